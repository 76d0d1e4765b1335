/* fit.h - fits lines through measurements. */
#ifndef FIT_H
#define FIT_H

/* Returns the exponent e of y ~ x^e: least-squares slope of log y over log x, count >= 2,
 * all > 0. NaN if any number is not. */
double fit_exponent(int count, const double *x, const double *y);

#endif
