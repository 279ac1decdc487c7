// What the functions of musl that are compiled here know of each other and of the compiler.
#pragma once

#include <features.h>
#include <stdint.h>

#define M_PI_2 1.57079632679489661923
#define NAN __builtin_nanf("")
#define INFINITY __builtin_inff()
#define isnan(x) __builtin_isnan(x)
#define isinf(x) __builtin_isinf(x)
#define signbit(x) __builtin_signbit(x)
#define fabs(x) __builtin_fabs(x)
#define fabsf(x) __builtin_fabsf(x)
#define sqrt(x) __builtin_sqrt(x)
#define floor(x) __builtin_floor(x)

typedef float float_t;
typedef double double_t;

double acos(double);
double asin(double);
double atan(double);
double atan2(double, double);
double cbrt(double);
double cos(double);
double exp(double);
double hypot(double, double);
double log(double);
double log2(double);
double pow(double, double);
double scalbn(double, int);
double sin(double);
double tan(double);
float cosf(float);
float sinf(float);
void sincos(double, double*, double*);
void sincosf(float, float*, float*);
