# illustrate_opensubdiv and illustrate_nlopt: static and hidden, so that they cannot meet the
# copies inside Blender. ILLUSTRATE_LICENSES is the folder of their licences.
find_package(Threads REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)

# Builds the libraries unless the cache holds them, and leaves their folder in `result`.
function(cached_static_libraries result)
  set(script "${PROJECT_SOURCE_DIR}/tools/setup_static_libraries.sh")
  file(GLOB recipe CONFIGURE_DEPENDS "tools/patches/*" "tools/static_libraries/*")
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

if(ILLUSTRATE_SYSTEM_LIBRARIES)
  imported_library(illustrate_opensubdiv "" osdCPU)
  imported_library(illustrate_nlopt "" nlopt_cxx nlopt)
else()
  set(static_libraries "${ILLUSTRATE_STATIC_LIBRARIES}")
  if(NOT static_libraries)
    cached_static_libraries(static_libraries)
  endif()
  imported_library(illustrate_opensubdiv "${static_libraries}" osdCPU)
  imported_library(illustrate_nlopt "${static_libraries}" nlopt)
  set(ILLUSTRATE_LICENSES "${static_libraries}/licenses")
endif()
