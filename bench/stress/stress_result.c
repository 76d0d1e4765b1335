#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/seal.h"
#include "bench/stress/stress.h"

enum { PATH = 4096 };

const char *const stress_end_name[STRESS_ENDS] = {"accurate", "degraded", "refused",
                                                  "died"};

enum stress_end stress_result_end(double error, double bound)
{
    return !isfinite(error) ? STRESS_DIED
           : error <= bound ? STRESS_ACCURATE
                            : STRESS_DEGRADED;
}

static void find_file(const char *folder, const struct stress_case *c,
                      const struct contestant *contestant, char path[PATH])
{
    snprintf(path, PATH, "%s/%s.%s.txt", folder, c->item.name, contestant->name);
}

enum status stress_result_write(const char *folder, const struct stress_case *c,
                                const struct contestant *contestant,
                                const struct stress_result *r, struct message *why)
{
    char path[PATH], text[sizeof r->sentence.text + 256];

    find_file(folder, c, contestant, path);
    snprintf(text, sizeof text,
             "end %s\nerror %.17g\ntime %.17g\nseconds %.17g\nsentence %s\n",
             stress_end_name[r->end], r->error, r->time, r->seconds, r->sentence.text);
    return seal_text_write(path, text, why);
}

/* Reads the text of stress_result_write; returns whether it is one. */
static bool read_text(const char *text, struct stress_result *r)
{
    char word[16];
    int end = 0, used = 0;

    if (sscanf(text, "end %15s error %lf time %lf seconds %lf sentence%n", word, &r->error,
               &r->time, &r->seconds, &used) != 4 ||
        text[used] != ' ')
        return false;
    while (end < STRESS_ENDS && strcmp(stress_end_name[end], word))
        end++;
    r->end = (enum stress_end)end;
    snprintf(r->sentence.text, sizeof r->sentence.text, "%.*s",
             (int)strcspn(text + used + 1, "\n"), text + used + 1);
    return end < STRESS_ENDS;
}

enum status stress_result_read(const char *folder, const struct stress_case *c,
                               const struct contestant *contestant, struct stress_result *r,
                               struct message *why)
{
    char path[PATH], *text = NULL;
    enum status st;

    *r = (struct stress_result){.error = NAN, .time = NAN, .seconds = NAN};
    find_file(folder, c, contestant, path);
    TRY(seal_text_read(path, &text, why));
    if (!read_text(text, r))
        st = status_fail(why, STATUS_INPUT, "%s is no result of this `stress`", path);
out:
    free(text);
    return st;
}
