# illustrate_compiler: how our own code is compiled.
#
# No flag may change results: no fast-math, no contraction of a*b+c, so that the same input gives
# the same bytes on every machine. errno of the math functions is the one thing given up.
add_library(illustrate_compiler INTERFACE)

if(MSVC)  # clang-cl: Microsoft's own compiler lacks the 128-bit integers of the predicates
  target_compile_options(illustrate_compiler INTERFACE
    /W3 /EHsc /bigobj /utf-8 /clang:-fno-math-errno /clang:-ffp-contract=off)
  target_compile_definitions(illustrate_compiler INTERFACE NOMINMAX _USE_MATH_DEFINES)
elseif(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
  # Indices are int; Clang's -Wconversion, unlike GCC's, would object to each use of one.
  target_compile_options(illustrate_compiler INTERFACE
    -fno-math-errno -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
    -Wnon-virtual-dtor -Woverloaded-virtual)
  if(WIN32)
    target_compile_definitions(illustrate_compiler INTERFACE NOMINMAX _USE_MATH_DEFINES)
  endif()
endif()

# Build type Sanitize: ends at the first memory error or undefined behaviour.
set(CMAKE_CXX_FLAGS_SANITIZE "-O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined \
-fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS")

# Build type Unoptimised: each statement as written, with the asserts of Eigen and of the standard
# library. What a compiler may do with undefined behaviour it does differently here.
set(CMAKE_CXX_FLAGS_UNOPTIMISED "-O0 -g1 -D_GLIBCXX_ASSERTIONS")

# Build type Coverage: counts how often each line runs. Without optimisation the tests take forty
# minutes; at -O1 the compiler takes what inlined code sets for unset.
set(CMAKE_CXX_FLAGS_COVERAGE "-O1 -g1 --coverage -Wno-maybe-uninitialized")
