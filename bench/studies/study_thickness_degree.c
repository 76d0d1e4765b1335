#include <math.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"
#include "bench/studies/studies.h"
#include "bench/truth/truth_plate.h"

enum { DEGREES = 3 };

/* Sheets alike: what the paper's Table 1 takes for the same look [m]. */
static const double ALIKE = 0.04;

/* Tip over Kirchhoff's, and the error of the whole field. */
struct worth {
    const struct study *plate;
    double tip[DEGREES], error[DEGREES];
};

static enum status read_worth(const struct study *plate, struct worth *w,
                              struct message *why)
{
    struct truth_plate truth = {0};
    enum status st;

    w->plate = plate;
    TRY(truth_plate_init(&truth, &plate->row[0].run.scene, 0, NULL, why));
    for (int n = 0; n < DEGREES; n++) {
        const double *xyz = plate->row[n].frame[0].xyz;
        w->tip[n] = xyz ? truth_plate_tip(&truth, xyz) : NAN;
        w->error[n] = xyz ? truth_plate_error(&truth, 0, xyz) : NAN;
    }
out:
    truth_plate_clear(&truth);
    return st;
}

static enum status print_worth(const struct worth *w, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"level", NULL, TABLE_LEFT}, {"tip / Kirchhoff", "1"}, {"error", "%"}};
    const double nu = w->plate->row[0].run.scene.poisson;
    struct table *t = table_create(3, columns, w->plate->plan->caption);

    for (int n = 0; n < DEGREES; n++) {
        table_row(t);
        table_text(t, "%s", w->plate->row[n].level->label);
        table_number(t, w->tip[n], 4);
        table_number(t, 100 * w->error[n], 3);
    }
    table_note(t,
               "Error: RMSE of the displacement over the rms displacement of the Kirchhoff "
               "plate. A strip with r = 1 would have (1 - 2 nu) / (1 - nu)^2 = %.4g of its "
               "deflection, however fine the net.",
               (1 - 2 * nu) / pow(1 - nu, 2));
    return table_finish(t, format, file);
}

/* How far r = 1 and the highest r are apart at most [m]; NaN: one of them died. */
static double farthest(const struct study *s)
{
    double apart = 0;

    for (int t = 0; t < s->frames; t++)
        apart = judge_most(apart, s->row[0].frame[t].finest * s->length);
    return apart;
}

static void judge_look(const struct study *s, const char *net, FILE *file)
{
    double apart = farthest(s);

    judge_print(file, "little difference to the linear basis", judge_below(apart, ALIKE),
                "%s: r = 1 and %s are up to %.3g m apart (RMSE at %g to %g s); "
                "Table 1 takes %g m for the same look.",
                net, s->plan->levels[s->plan->level_count - 1].label, apart, s->time[0],
                s->time[s->frames - 1], ALIKE);
}

static void judge_cost(const struct study *s, FILE *file)
{
    const double ms[] = {s->row[0].milliseconds, s->row[1].milliseconds,
                         s->row[2].milliseconds};

    judge_print(
        file, "considering the cost, the linear basis", judge_order(DEGREES, ms, 1, 0),
        "A frame costs %.3g, %.3g and %.3g ms with r = 1, 2, 3: %.2g and %.2g times "
        "as much.",
        ms[0], ms[1], ms[2], ms[1] / ms[0], ms[2] / ms[0]);
}

/* A higher degree helps if it more than halves the error. */
static void explain(const struct study *cloak, const struct study *better,
                    const struct worth *w, FILE *file)
{
    const double off[] = {fabs(1 - w->tip[0]), fabs(1 - w->tip[1]), fabs(1 - w->tip[2])};

    judge_say(
        file,
        "On a plate whose answer is known, the tip is off by %.3g %% with r = 1 (%s), "
        "%.3g %% with r = 2 and %.3g %% with r = 3: %s. At Gamma = %.4g the cloak moves "
        "%.2g m (the paper's net) or %.2g m (degree 4) for it.",
        100 * off[0], w->tip[0] < 1 ? "too stiff" : "too soft", 100 * off[1], 100 * off[2],
        judge_words(
            judge_both(judge_below(2 * off[1], off[0]), judge_below(2 * off[2], off[0])),
            "little difference is not accuracy, for with a strain that cannot "
            "vary through the thickness the sheet cannot narrow where it is "
            "stretched and widen where it is pressed",
            "a higher degree does not help", "what it is worth is not known"),
        cloak->gamma, farthest(cloak), farthest(better));
}

static enum status tell(const struct study_results *r, const char *folder,
                        enum table_format format, FILE *file, struct message *why)
{
    const struct study *const cloaks[] = {study_find(r, "cloak"), study_find(r, "better")};
    struct worth worth;
    enum status st;

    for (int n = 0; n < 2; n++)
        TRY(study_print(cloaks[n], folder, format, file, why));
    TRY(read_worth(study_find(r, "plate"), &worth, why));
    TRY(print_worth(&worth, format, file));
    if (!table_format_is_prose(format))
        return STATUS_OK;
    fprintf(file, "The paper's sentences\n\n");
    judge_look(cloaks[0], "The paper's net", file);
    judge_look(cloaks[1], "Degree 4 in the plane", file);
    judge_cost(cloaks[0], file);
    explain(cloaks[0], cloaks[1], &worth, file);
out:
    return st;
}

const struct experiment study_thickness_degree = {
    .item = {"thickness-degree", NULL}, .plan = "thickness-degree", .tell = tell};
