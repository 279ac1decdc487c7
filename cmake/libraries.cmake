# illustrate_opensubdiv, illustrate_nlopt and illustrate_math: static and hidden, so that they cannot
# meet the copies inside Blender. ILLUSTRATE_LICENSES is the folder of their licences.
include(cmake/search_paths.cmake)
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)

# Builds the libraries unless the cache holds them, and leaves their folder in `result`.
function(cached_static_libraries result)
  set(script "${PROJECT_SOURCE_DIR}/tools/setup_static_libraries.sh")
  file(GLOB_RECURSE recipe CONFIGURE_DEPENDS "tools/patches/*" "tools/static_libraries/*")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${script}" ${recipe})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env CMAKE=${CMAKE_COMMAND} CXX=${CMAKE_CXX_COMPILER} ${script}
    OUTPUT_VARIABLE folder OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  set(${result} "${folder}" PARENT_SCOPE)
endfunction()

# imported_library(target include_folder name...): the first of the names found.
function(imported_library target folder)
  if(folder)
    set(where PATHS "${folder}/lib" NO_DEFAULT_PATH)
  endif()
  unset(library CACHE)
  find_library(library NAMES ${ARGN} REQUIRED ${where})
  add_library(${target} INTERFACE IMPORTED)
  target_link_libraries(${target} INTERFACE "${library}")
  if(folder)
    target_include_directories(${target} INTERFACE "${folder}/include")
  endif()
  unset(library CACHE)
endfunction()

# build_libraries(folder): all from their sources, as a part of this build; on any system. NLopt's
# generator scripts need CMAKE_POLICY_VERSION_MINIMUM=3.5 in the environment of the build too.
function(build_libraries folder)
  set(CMAKE_COMPILE_WARNING_AS_ERROR OFF)
  set(CMAKE_C_VISIBILITY_PRESET hidden)
  if(NOT MSVC)
    string(APPEND CMAKE_C_FLAGS " -ffp-contract=off")
    string(APPEND CMAKE_CXX_FLAGS " -ffp-contract=off")
  endif()
  set(OPENSUBDIV_SOURCE "${folder}/opensubdiv" CACHE PATH "" FORCE)
  add_subdirectory(tools/static_libraries "${PROJECT_BINARY_DIR}/opensubdiv" EXCLUDE_FROM_ALL)
  add_library(illustrate_opensubdiv INTERFACE)
  target_link_libraries(illustrate_opensubdiv INTERFACE osdCPU)
  target_include_directories(illustrate_opensubdiv SYSTEM INTERFACE "${OPENSUBDIV_SOURCE}")

  set(CMAKE_POLICY_VERSION_MINIMUM 3.5)
  # Its own option() of this name asks the cache alone, and is ON unless it is there.
  set(BUILD_SHARED_LIBS OFF CACHE BOOL "" FORCE)
  foreach(language PYTHON OCTAVE MATLAB GUILE SWIG TESTS)
    set(NLOPT_${language} OFF CACHE BOOL "" FORCE)
  endforeach()
  add_subdirectory("${folder}/nlopt" "${PROJECT_BINARY_DIR}/nlopt" EXCLUDE_FROM_ALL)
  add_library(illustrate_nlopt INTERFACE)
  target_link_libraries(illustrate_nlopt INTERFACE nlopt)
  target_include_directories(illustrate_nlopt SYSTEM INTERFACE
    "${folder}/nlopt/src/api" "${PROJECT_BINARY_DIR}/nlopt")

  add_library(illustrate_math INTERFACE)
  # On macOS zig takes the system's functions before those of archives; and musl is not written for
  # MSVC. There the system's are used.
  if(NOT MSVC AND NOT APPLE)
    set(MUSL_SOURCE "${folder}/musl" CACHE PATH "" FORCE)
    add_subdirectory(tools/static_libraries/math "${PROJECT_BINARY_DIR}/math" EXCLUDE_FROM_ALL)
    target_link_libraries(illustrate_math INTERFACE illustrate_musl)
  endif()
endfunction()

if(ILLUSTRATE_LIBRARY_SOURCES)
  build_libraries("${ILLUSTRATE_LIBRARY_SOURCES}")
  set(ILLUSTRATE_LICENSES "${ILLUSTRATE_LIBRARY_SOURCES}/licenses")
elseif(ILLUSTRATE_SYSTEM_LIBRARIES)
  imported_library(illustrate_opensubdiv "" osdCPU)
  imported_library(illustrate_nlopt "" nlopt_cxx nlopt)
  add_library(illustrate_math INTERFACE)
else()
  set(static_libraries "${ILLUSTRATE_STATIC_LIBRARIES}")
  if(NOT static_libraries)
    cached_static_libraries(static_libraries)
  endif()
  imported_library(illustrate_opensubdiv "${static_libraries}" osdCPU)
  imported_library(illustrate_nlopt "${static_libraries}" nlopt)
  imported_library(illustrate_math "${static_libraries}" illustrate_musl)
  set(ILLUSTRATE_LICENSES "${static_libraries}/licenses")
endif()

# They compute with it too.
target_link_libraries(illustrate_opensubdiv INTERFACE illustrate_math)
target_link_libraries(illustrate_nlopt INTERFACE illustrate_math)

if(NOT ILLUSTRATE_SYSTEM_LIBRARIES)
  refuse_system_headers(opensubdiv illustrate_opensubdiv)
  refuse_system_headers(nlopt.h illustrate_nlopt)
  refuse_system_headers(nlopt.hpp illustrate_nlopt)
endif()
