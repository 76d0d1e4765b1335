/* distribution.h - what an ensemble of runs says of a number, and whether two ensembles say
 * the same: the runs are independent, nothing is taken to be normal but means of them.
 */
#ifndef DISTRIBUTION_H
#define DISTRIBUTION_H

enum { DISTRIBUTION_RUNS = 256 };

/* The mean of value[n], and its standard error, sd / sqrt(n); NaN of too few. */
double distribution_mean(int n, const double *value, double *error);

/* How far the means of a[n] and b[m] are apart in standard errors, (mean a - mean b) /
 * sqrt(se^2 + se^2 + bar^2): Welch (1938), and `bar`, what b's mean may be off by besides.
 * Equal means are 0 apart, others without any error infinitely. */
double distribution_apart(int n, const double *a, int m, const double *b, double bar);

/* |value - median| of each: their means tell spreads apart, whatever the shape of the
 * distribution (Brown, Forsythe 1974). n <= DISTRIBUTION_RUNS. */
void distribution_deviations(int n, const double *value, double *deviation);

/* How far apart means of n runs each may be in standard errors before they are not of one
 * distribution: of so many comparisons none passes it by chance in all but 5 of 100 cases
 * (Bonferroni; Student's t of n - 1 degrees of freedom, the fewest that Welch's may have).
 * INFINITY for fewer than two runs. */
double distribution_bound(int comparisons, int n);

#endif
