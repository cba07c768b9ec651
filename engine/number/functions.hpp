// Elementary functions of doubles whose last bit is the same on every machine. Those of <cmath> are only near: C
// libraries differ in one argument of some twenty, and so would layouts and printed digits between the program and the
// browser. These are the nearest doubles, but for one argument in many millions (the exact value lies too near the
// middle between two); there, too, every machine with IEEE arithmetic has the same.
#pragma once

namespace kinegraph::nearest {

double sin(double x);
double cos(double x);
double tan(double x);
double asin(double x);
double acos(double x);
double atan(double x);
double atan2(double y, double x);
double exp(double x);
double log(double x);
double log10(double x);
double pow(double base, double exponent);
double sinh(double x);
double cosh(double x);
double tanh(double x);
double cbrt(double x);
double hypot(double x, double y);

}  // namespace kinegraph::nearest
