# After CMake's own rules for macOS, which make bundles of modules: zig links none. A module is a
# library that finds Python's functions in the program.
set(CMAKE_SHARED_MODULE_CREATE_C_FLAGS "-shared -Wl,-undefined,dynamic_lookup")
set(CMAKE_SHARED_MODULE_CREATE_CXX_FLAGS "-shared -Wl,-undefined,dynamic_lookup")
