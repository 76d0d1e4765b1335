/* The checks of verify in full, the dear rows, too, by a model that computes nothing: its
 * answers are a smooth function of everything that scene and discretization say. So what a
 * check asks for, and what it makes of the answer, cannot change unseen: sums over its rows
 * are stored in verify_scripted.txt. A line that differs is printed as it would stand
 * there: grep '^line: '; the rows are in FOLDER. test_verify_scripted FOLDER */
#include <stdint.h>

#include "bench/files/folder.h"
#include "bench/truth/truth_physics.h"
#include "bench/verify/verify_file.h"
#include "models/grid.h"
#include "tests/check.h"

/* Those that some of are left out of by --quick; the others run as they are. */
#define CHECKS(X)                                                                          \
    X(elastica), X(sze), X(fabrics), X(navier), X(frequencies), X(cantilever), X(lateral), \
        X(postbuckling), X(hanging), X(pendulum), X(transient), X(energy), X(contact)
#define CHECK_NAME(name) verify_##name
extern const struct verify_check CHECKS(CHECK_NAME);
#define CHECK_ADDRESS(name) &verify_##name
static const struct verify_check *const checks[] = {CHECKS(CHECK_ADDRESS)};

/* --- The model. */

struct fake {
    struct model model; /* with what the contestant's own has                            */
    const struct scene *scene;
    double r; /* all that it was told, some units                                       */
    int frame;
    bool settled;
};

/* The next number of all: the k-th has its own weight. */
static void hear(double *r, int *k, double x)
{
    *r += 0.05 * sin(1.7 * ++*k) * copysign(log1p(fabs(x)), x);
}

static void hear_text(double *r, int *k, const char *text)
{
    for (char *after; *text; text = after) {
        const double x = strtod(text, &after);
        if (after == text)
            hear(r, k, *after++);
        else
            hear(r, k, x);
    }
}

static double hear_all(const struct run *run)
{
    const struct scene *s = &run->scene;
    const struct discretization *d = &run->discretization;
    double r = 0;
    int k = 0;
    char *physics = NULL;

    REQUIRE(truth_physics(s, &physics) == STATUS_OK);
    hear_text(&r, &k, physics);
    free(physics);
    hear(&r, &k, 1e3 * s->step);
    hear(&r, &k, s->end);
    for (int i = 0; i < 3; i++) {
        hear(&r, &k, d->points[i]);
        hear(&r, &k, d->degree[i]);
        for (int n = 0; n < d->knot_count[i]; n++)
            hear(&r, &k, d->knots[i][n]);
    }
    hear(&r, &k, (double)d->kinematics);
    hear(&r, &k, (double)d->remedy);
    hear(&r, &k, 1e6 * d->tolerance);
    hear(&r, &k, d->iterations);
    return r;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct fake *f = state;
    const double t = f->frame * f->scene->step;

    for (int p = 0; p < n; p++, uvw += 3, xyz += 3) {
        const double late = uvw[0] + uvw[1] + uvw[2];
        const double grown = f->settled ? 1 : 1 - exp(-3 * t) * cos(5 * t + late);
        const double shape = (0.1 + uvw[0]) * (1 + 0.3 * uvw[1]) * (1 + 0.1 * uvw[2]);
        const double way = 0.5 * f->scene->length * (2 + sin(8 * f->r)) * shape * grown;
        scene_rest_point(f->scene, uvw, xyz);
        xyz[0] -= 0.2 * way;
        xyz[1] += 0.03 * way;
        xyz[2] -= way;
    }
}

static void sample(const void *state, double *xyz)
{
    double uvw[3];

    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        probe(state, 1, uvw, xyz + 3 * n);
    }
}

static enum status advance(void *state, struct counters *work)
{
    struct fake *f = state;

    f->frame++;
    work->steps++;
    work->iterations += 3;
    work->substeps += 2;
    return STATUS_OK;
}

static enum status equilibrium(void *state, struct counters *work, struct message *why)
{
    (void)work, (void)why;
    ((struct fake *)state)->settled = true;
    return STATUS_OK;
}

/* The lowest changes its sign now and then. */
static enum status modes(void *state, int count, double *omega, struct message *why)
{
    const struct fake *f = state;

    (void)why;
    omega[0] = 20 * sin(40 * f->r);
    for (int k = 1; k < count; k++)
        omega[k] = 20 * (k + 1 + 0.5 * sin(3 * f->r)) + f->settled;
    return STATUS_OK;
}

static void energy(const void *state, struct energy *e)
{
    const struct fake *f = state;
    const double g = f->settled ? 2 : sin(0.1 * f->frame);

    *e = (struct energy){0.5 * g * g, (1 + 0.1 * sin(f->r)) * g * g, -1.4 * fabs(g)};
}

static void contact(const void *state, struct model_contact *c)
{
    const struct fake *f = state;

    *c = (struct model_contact){
        1, 1e-3 * (2 + sin(f->r) + cos(f->frame)), {0, 0, 1.5 + sin(f->r + f->frame)}};
}

enum status __wrap_run_build(struct run *run, struct message *why);

/* In place of what builds the contestant's model. */
enum status __wrap_run_build(struct run *run, struct message *why)
{
    struct fake *f = malloc(sizeof *f);
    const struct model *own = run->model;

    (void)why;
    REQUIRE(f);
    *f = (struct fake){.model = *own, .scene = &run->scene, .r = hear_all(run)};
    f->model.probe = probe, f->model.sample = sample, f->model.advance = advance;
    f->model.equilibrium = own->equilibrium ? equilibrium : NULL;
    f->model.modes = own->modes ? modes : NULL;
    f->model.energy = own->energy ? energy : NULL;
    f->model.contact = own->contact ? contact : NULL;
    f->model.destroy = free;
    run->model = &f->model;
    run->state = f;
    return STATUS_OK;
}

/* --- Sums. */

enum { NUMBERS = 6 };

/* Of sizes from 1e-11 up (below is round-off), and of what is no number. */
static double size_of(double x)
{
    return isnan(x) ? 0.1234 : isinf(x) ? 50 : log(fabs(x) + 1e-11) + (x < 0);
}

static uint32_t add_words(uint32_t sum, const char *text) /* FNV-1a, 32 bits */
{
    for (; *text; text++)
        sum = (sum ^ (unsigned char)*text) * 16777619u;
    return sum * 16777619u;
}

static void add_row(const struct verify_row *row, int n, double sum[NUMBERS],
                    uint32_t *words)
{
    const double number[NUMBERS] = {row->value, row->truth,     row->bar,
                                    row->error, row->tolerance, row->order};

    for (int k = 0; k < NUMBERS; k++)
        sum[k] += (1 + n * 7 % 11 / 10.0) * size_of(number[k]);
    *words = add_words(add_words(*words, row->quantity), row->subject);
    *words = add_words(add_words(*words, row->note), row->changed);
    *words = add_words(*words, verify_verdict_name((int)row->verdict));
}

/* Whether the line that is stored says the same. */
static bool is_stored(const char *name, int rows, const double sum[NUMBERS], uint32_t words,
                      FILE *list)
{
    char line[512], known[64];
    double want[NUMBERS];
    unsigned hash;
    int count;

    rewind(list);
    while (fgets(line, sizeof line, list))
        if (sscanf(line, "%63s %d %x %lf %lf %lf %lf %lf %lf", known, &count, &hash,
                   &want[0], &want[1], &want[2], &want[3], &want[4], &want[5]) == 9 &&
            !strcmp(known, name)) {
            bool same = count == rows && hash == words;
            for (int k = 0; k < NUMBERS; k++)
                same &= fabs(sum[k] - want[k]) <= 1e-6 * (1 + fabs(want[k]));
            return same;
        }
    return false;
}

static void try_check(const struct verify_check *check, const char *folder, FILE *list)
{
    struct verify_sheet sheet = {0};
    struct message why = {""};
    double sum[NUMBERS] = {0};
    uint32_t words = 2166136261u;

    if (!check->table || verify_sheet_table(&sheet, check->table))
        check->run(&sheet);
    if (!CHECK(sheet.status == STATUS_OK))
        printf("%s: %s\n", check->item.name, sheet.why.text);
    for (int n = 0; n < sheet.count; n++)
        add_row(&sheet.rows[n], n, sum, &words);
    CHECK(verify_file_write(check, &sheet, folder, &why) == STATUS_OK);
    if (!CHECK(is_stored(check->item.name, sheet.count, sum, words, list)))
        printf("line: %s %d %08x %.9g %.9g %.9g %.9g %.9g %.9g\n", check->item.name,
               sheet.count, (unsigned)words, sum[0], sum[1], sum[2], sum[3], sum[4],
               sum[5]);
    verify_sheet_clear(&sheet);
}

int main(int argc, char **argv)
{
    FILE *list = fopen(SOURCE_DIR "/tests/verify_scripted.txt", "r");

    REQUIRE(argc == 3 && list && folder_make(argv[2], NULL) == STATUS_OK);
    for (size_t n = 0; n < sizeof checks / sizeof *checks; n++)
        if (!strcmp(argv[1], checks[n]->item.name))
            try_check(checks[n], argv[2], list);
    fclose(list);
    return check_result();
}
