/* Times what the orthotropic law costs: the same sheet on edge_drop, once by E and nu and
 * once as a fabric of the same stiffness, in turn. */
#include "bench/speed/bench.h"
#include "models/law/law.h"

static const char *const contestants[] = {
    "shell_3",   "shell_selective_3", "iga_selective_3",
    "triangles", "mass_spring",       "position_based",
    "vbd"};
enum { CONTESTANTS = sizeof contestants / sizeof *contestants };
static const double ASKED = 1.15; /* ratio of the times */

static enum status plan(struct bench *b, struct message *why)
{
    const double young = 1e5, poisson = 0.3, density = 0.5, thickness = 0.001177;
    const struct law law = law_isotropic(young, poisson, thickness);
    const double *Y = law.matrix[LAW_MEMBRANE], *B = law.matrix[LAW_BENDING];
    char fabric[512];
    enum status st = STATUS_OK;

    snprintf(fabric, sizeof fabric,
             "material={membrane: [%.17g, %.17g, %.17g, %.17g], bending: [%.17g, %.17g, "
             "%.17g, %.17g], areal_density: %.17g}",
             Y[LAW_11], Y[LAW_22], Y[LAW_12], Y[LAW_33], B[LAW_11], B[LAW_22], B[LAW_12],
             B[LAW_33], density * thickness);
    for (int n = 0; n < 2 * CONTESTANTS && st == STATUS_OK; n++)
        st = bench_part_add(
            b,
            &(struct bench_row){NULL,
                                contestants[n / 2],
                                {"damping={kind: none}", n % 2 ? fabric : NULL},
                                0.2,
                                0,
                                {0}},
            why);
    return st;
}

static enum status print(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"model", NULL, TABLE_LEFT},
                                                  {"isotropic", "ms"},
                                                  {"fabric", "ms"},
                                                  {"ratio"},
                                                  {"repeats"},
                                                  {"reached", NULL, TABLE_LEFT}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "A frame of the same sheet by both laws, edge_drop to "
                                   "0.2 s, one thread");

    (void)why;
    for (int n = 0; n < b->batch.count; n += 2) {
        const struct clock_summary *plain = &b->result[n].step,
                                   *cloth = &b->result[n + 1].step;
        table_row(t);
        table_text(t, "%s", b->batch.cases[n].plan.contestant->title);
        table_number(t, 1e3 * plain->min, 3);
        table_number(t, 1e3 * cloth->min, 3);
        table_number(t, cloth->min / plain->min, 3);
        table_integer(t, cloth->count);
        table_text(t, "%s", cloth->min <= ASKED * plain->min ? "yes" : "no");
    }
    table_note(t, "The least of the repeats counts. Asked is a ratio of %g at most.",
               ASKED);
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_fabrics = {
    .item = {"fabrics", "the same sheet as isotropic and as a fabric"},
    .plan = plan,
    .print = print};
