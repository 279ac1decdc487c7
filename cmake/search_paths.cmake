# What the build may find: what the set-up scripts install, and nothing that merely lies there.

# Packages of other checkouts and of the user's environment are not looked for.
set(CMAKE_FIND_USE_PACKAGE_REGISTRY OFF)
set(CMAKE_FIND_USE_SYSTEM_PACKAGE_REGISTRY OFF)
set(CMAKE_EXPORT_NO_PACKAGE_REGISTRY ON)

# refuse_system_headers(name target): <name/...> is an error for whoever does not link `target`.
#
# The compiler looks in the system's folder for every target, linked or not, so a target that
# forgets its library compiles on machines where a package of the system happens to lie, and
# nowhere else. In front of the system's folder, behind those of all libraries linked, comes a
# folder with the same names that says what to do.
function(refuse_system_headers name target)
  set(refused "${PROJECT_BINARY_DIR}/refused")
  file(REMOVE_RECURSE "${refused}/${name}")
  foreach(folder IN LISTS CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    if(NOT EXISTS "${folder}/${name}")
      continue()
    endif()
    message(STATUS "${folder}/${name} is not used: ${target} has its own")
    set(headers "${name}")
    if(IS_DIRECTORY "${folder}/${name}")
      file(GLOB_RECURSE headers RELATIVE "${folder}" "${folder}/${name}/*")
    endif()
    foreach(header IN LISTS headers)
      file(WRITE "${refused}/${header}"
        "#error \"${folder}/${header} is the system's, not ours: link ${target}\"\n")
    endforeach()
  endforeach()
  if(EXISTS "${refused}")
    set(CMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES "${refused}" PARENT_SCOPE)
  endif()
endfunction()
