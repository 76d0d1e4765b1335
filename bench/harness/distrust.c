#include "bench/harness/distrust.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "bench/harness/looks.h"

__attribute__((format(printf, 2, 3))) static void say(struct message *m, const char *format,
                                                      ...)
{
    const size_t used = strlen(m->text);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(m->text + used, sizeof m->text - used, format, arguments);
    va_end(arguments);
}

bool distrust(const struct scene *scene, const double value[MEASURES],
              struct message *sentence)
{
    const double stretch = value[MEASURE_STRETCH_MAX],
                 weight = value[MEASURE_HANGING_STRAIN],
                 depth = value[MEASURE_PENETRATION_MAX],
                 begin = value[MEASURE_INTERSECTION_TIME];
    const bool stretched = stretch > fmax(DISTRUST_STRETCH, 1 + 2 * weight),
               deep = depth > DISTRUST_DEPTH * scene->thickness,
               crossed = value[MEASURE_INTERSECTIONS_MAX] > 0, moved = begin > 0,
               coarse = stretched || deep || !moved;

    sentence->text[0] = '\0';
    if (!stretched && !deep && !crossed)
        return false;
    say(sentence, "Do not trust this result: ");
    if (stretched)
        say(sentence,
            "the mid-surface is stretched to %.3g times its length, of which its hanging "
            "weight explains %.4g",
            stretch, 1 + weight);
    if (deep)
        say(sentence, "%san obstacle is %.2g mm deep in a sheet of %.2g mm",
            stretched ? ", " : "", 1e3 * depth, 1e3 * scene->thickness);
    if (crossed)
        say(sentence, "%sit passes through itself", stretched || deep ? ", " : "");
    if (crossed && moved)
        say(sentence, " from %.3g s on", begin);
    say(sentence, "; try %s%s", coarse ? "a finer net" : "",
        stretched ? ", another model beside it" : "");
    if (crossed && moved)
        say(sentence, "%san end before %.3g s, as no model here keeps a sheet off itself",
            coarse ? ", or " : "", begin);
    say(sentence, ".");
    return true;
}

enum status distrust_fields(const struct scene *scene, int count, const double *time,
                            double *const *xyz, struct message *sentence)
{
    struct looks looks;
    double value[MEASURES];
    enum status st;

    TRY(looks_init(&looks, count));
    for (int n = 0; n < count; n++)
        looks_add(&looks, scene, time[n], xyz[n], true);
    TRY(looks_reduce(&looks, scene, STATUS_OK, NAN, value));
    distrust(scene, value, sentence);
out:
    looks_clear(&looks);
    return st;
}
