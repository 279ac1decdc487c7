// Of complex numbers only the size is needed, which takes hypot.
#pragma once

#define complex _Complex
#define creal(z) __builtin_creal(z)
#define cimag(z) __builtin_cimag(z)

double cabs(double complex);
