// A module that a new compiler made asks for a new C library and a new C++ library, although it
// uses nothing that the old ones lack: a newer version of one function, and small functions that
// headers used to have inside. Here are the old versions, so that it loads wherever Blender does,
// which asks for glibc 2.28 and the C++ library of GCC 8.
//
// The linker sends calls of the function wrapped here to __wrap_* (option --wrap). What the rest
// defines comes before the C++ library's own, and is seen inside this module only.

#ifdef ILLUSTRATE_OLD_SYSTEMS

#include <pthread.h>
#include <exception>
#include <new>

extern "C" {

__asm__(".symver old_pthread_once, pthread_once@GLIBC_2.2.5");
int old_pthread_once(pthread_once_t* once, void (*function)());

int __wrap_pthread_once(pthread_once_t* once, void (*function)()) {
  return old_pthread_once(once, function);
}

// Reference counts are atomic always.
char __libc_single_threaded = 0;

// Copying and destroying an exception_ptr, as the C++ library has them from GCC 4.4 on.
void copy_exception(void* copy,
                    const void* original) __asm__("_ZNSt15__exception_ptr13exception_ptrC1ERKS0_");
void destroy_exception(void* pointer) __asm__("_ZNSt15__exception_ptr13exception_ptrD1Ev");
}

namespace std {

void __throw_bad_array_new_length() { throw bad_array_new_length(); }

namespace __exception_ptr {

// One more owner: a copy that nobody destroys.
void exception_ptr::_M_addref() noexcept {
  void* copy = nullptr;
  copy_exception(&copy, this);
}

// One owner less: what that copy would do at its end.
void exception_ptr::_M_release() noexcept {
  void* copy = _M_exception_object;
  destroy_exception(&copy);
}

}  // namespace __exception_ptr
}  // namespace std

#endif
