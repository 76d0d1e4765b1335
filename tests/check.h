/* check.h - a test is a program that counts failed checks and goes on; it returns
 * check_result(). Tolerances are passed by name, so that the report names them.
 * CHECK_TOL_SCALE=0 in the environment makes every tolerance zero: each residual is then
 * printed beside its allowance. NaN fails. Tests have math, stdio, stdlib and string from
 * here. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int check_failures, check_count;

static inline double check_scale(void)
{
    const char *text = getenv("CHECK_TOL_SCALE");
    return text ? strtod(text, NULL) : 1.0;
}

static inline bool check_near(const char *file, int line, const char *what, double actual,
                              double want, const char *tol_name, double tol)
{
    double error = fabs(actual - want);
    check_count++;
    if (error <= tol * check_scale())
        return true;
    check_failures++;
    printf("%s:%d: %s = %.17g, want %.17g: error %.2e, %s %.2e\n", file, line, what, actual,
           want, error, tol_name, tol);
    return false;
}

static inline bool check_true(const char *file, int line, const char *what, bool holds)
{
    check_count++;
    if (holds)
        return true;
    check_failures++;
    printf("%s:%d: does not hold: %s\n", file, line, what);
    return false;
}

/* Says more where a check fails: of which row, what is there instead. */
__attribute__((format(printf, 1, 2))) static inline bool check_say(const char *format, ...)
{
    va_list list;

    va_start(list, format);
    printf("  ");
    vprintf(format, list);
    putchar('\n');
    va_end(list);
    return false;
}

/* So that compilers do not miss a use of the value. */
static inline bool check_all(bool hold)
{
    return hold;
}

#define CHECK(condition) check_true(__FILE__, __LINE__, #condition, (condition))

#define SAY_UNLESS(checks, ...)   check_all((checks) || check_say(__VA_ARGS__))
#define CHECK_SAY(condition, ...) SAY_UNLESS(CHECK(condition), __VA_ARGS__)

#define CHECK_HAS(text, part)                                                              \
    CHECK_SAY(strstr(text, part), "'%s' is not in\n%.2000s", part, text)

/* |actual - want| <= tol */
#define CHECK_NEAR(actual, want, tol)                                                      \
    check_near(__FILE__, __LINE__, #actual, (actual), (want), #tol, (tol))

/* |actual - want| <= tol |want| */
#define CHECK_RELATIVE(actual, want, tol)                                                  \
    check_near(__FILE__, __LINE__, #actual, (actual), (want), #tol " x |want|",            \
               (tol)*fabs(want))

/* For set-up that must succeed: without it the rest makes no sense. */
#define REQUIRE(condition)                                                                 \
    do {                                                                                   \
        if (!CHECK(condition)) {                                                           \
            printf("%s:%d: cannot go on\n", __FILE__, __LINE__);                           \
            exit(1);                                                                       \
        }                                                                                  \
    } while (0)

#define REQUIRE_SAY(condition, ...)                                                        \
    do {                                                                                   \
        if (!CHECK_SAY(condition, __VA_ARGS__))                                            \
            exit(1);                                                                       \
    } while (0)

static inline int check_result(void)
{
    printf("%d checks, %d failed\n", check_count, check_failures);
    return check_failures || !check_count ? 1 : 0;
}

#endif
