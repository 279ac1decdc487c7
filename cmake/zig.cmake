# Toolchain file: compiles for Windows and macOS on any machine, with the Clang and the libraries
# that the Python package ziglang brings.
#
# ILLUSTRATE_ZIG: the program zig, with wrappers beside it that tools/setup_zig.sh makes.
# ILLUSTRATE_TRIPLE: x86_64-windows-gnu, aarch64-macos.11.0 or x86_64-macos.11.0 (the oldest macOS).
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ILLUSTRATE_ZIG ILLUSTRATE_TRIPLE)

string(REGEX MATCH "^([^-]+)-([a-z]+)" start "${ILLUSTRATE_TRIPLE}")
set(CMAKE_SYSTEM_PROCESSOR ${CMAKE_MATCH_1})
set(system ${CMAKE_MATCH_2})

set(CMAKE_C_COMPILER ${ILLUSTRATE_ZIG}/zig-cc)
set(CMAKE_CXX_COMPILER ${ILLUSTRATE_ZIG}/zig-c++)
set(CMAKE_C_COMPILER_TARGET ${ILLUSTRATE_TRIPLE})
set(CMAKE_CXX_COMPILER_TARGET ${ILLUSTRATE_TRIPLE})
foreach(tool AR RANLIB)
  string(TOLOWER ${tool} name)
  set(CMAKE_${tool} ${ILLUSTRATE_ZIG}/zig-${name} CACHE FILEPATH "")
endforeach()

if(system STREQUAL "windows")
  set(CMAKE_SYSTEM_NAME Windows)
  set(CMAKE_RC_COMPILER ${ILLUSTRATE_ZIG}/zig-rc)
else()
  set(CMAKE_SYSTEM_NAME Darwin)
  # CMake asks for this tool of Apple's, which nothing here uses: no library is installed by name.
  set(CMAKE_INSTALL_NAME_TOOL true CACHE STRING "")
  set(CMAKE_USER_MAKE_RULES_OVERRIDE ${CMAKE_CURRENT_LIST_DIR}/zig_darwin.cmake)
endif()

# Eigen, headers alone, is that of this machine; nothing else of it may be found.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
