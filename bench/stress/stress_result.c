#include "bench/stress/stress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/files/output.h"

enum { PATH = 4096 };

static const char *const outcome_words[] = {
    [STRESS_RAN] = "ran", [STRESS_SAID_NO] = "refused", [STRESS_DEAD] = "died"};
enum { OUTCOMES = sizeof outcome_words / sizeof *outcome_words };

const char *stress_end_name(enum stress_end end)
{
    static const char *const names[] = {"accurate", "degraded", "refused", "died"};

    return names[end];
}

enum stress_end stress_result_end(const struct stress_result *r, double bound)
{
    if (r->outcome == STRESS_SAID_NO)
        return STRESS_REFUSED;
    if (r->outcome == STRESS_DEAD || !isfinite(r->error))
        return STRESS_DIED;
    return r->error <= bound ? STRESS_ACCURATE : STRESS_DEGRADED;
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
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    find_file(folder, c, contestant, path);
    TRY(output_create(path, &out, why));
    output_print(out, "outcome %s\nerror %.17g\ntime %.17g\nseconds %.17g\nsentence %s\n",
                 outcome_words[r->outcome], r->error, r->time, r->seconds,
                 r->sentence.text);
    st = output_close(out, why);
out:
    return st;
}

/* As stress_write has it, to the last line's end. */
static bool read_result(FILE *file, struct stress_result *r)
{
    char word[16];
    int outcome = 0;

    if (fscanf(file, "outcome %15s error %lf time %lf seconds %lf sentence%*1[ ]", word,
               &r->error, &r->time, &r->seconds) != 4 ||
        !fgets(r->sentence.text, sizeof r->sentence.text, file))
        return false;
    while (outcome < OUTCOMES && strcmp(outcome_words[outcome], word))
        outcome++;
    r->outcome = (enum stress_outcome)outcome;
    char *end = strchr(r->sentence.text, '\n');
    if (end)
        *end = '\0';
    return end && outcome < OUTCOMES;
}

enum status stress_result_read(const char *folder, const struct stress_case *c,
                               const struct contestant *contestant, struct stress_result *r,
                               struct message *why)
{
    char path[PATH];
    enum status st = STATUS_OK;

    *r = (struct stress_result){.error = NAN, .time = NAN, .seconds = NAN};
    find_file(folder, c, contestant, path);
    FILE *file = fopen(path, "r");
    if (!file)
        return status_fail(why, STATUS_FILE, "%s cannot be read", path);
    if (!read_result(file, r))
        st = status_fail(why, STATUS_INPUT, "%s is no result of `stress`", path);
    fclose(file);
    return st;
}
