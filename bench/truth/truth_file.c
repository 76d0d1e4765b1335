#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/files/store.h"
#include "bench/harness/run.h"
#include "bench/truth/truth_making.h"
#include "models/bodies/body_mesh.h"
#include "models/damping.h"
#include "models/grid.h"
#include "models/pattern.h"
#include "models/reader/scene_schema.h"

/* --- What it holds for --- */

static void print(FILE *out, const char *key, int count, const double *value)
{
    fprintf(out, "%s", key);
    for (int n = 0; n < count; n++)
        fprintf(out, " %.17g", value[n] + 0.0); /* no -0 */
    fputc('\n', out);
}

static void print_motion(const struct scene_motion *m, const char *whose, FILE *out)
{
    char key[32];

    snprintf(key, sizeof key, "%s path", whose);
    for (int row = 0; row < m->path_count; row++)
        print(out, key, 4, m->path[row]);
    if (m->turn_count) {
        print(out, "turn axis", 3, m->axis);
        print(out, "turn about", 3, m->about);
    }
    snprintf(key, sizeof key, "%s turn", whose);
    for (int row = 0; row < m->turn_count; row++)
        print(out, key, 2, m->turn[row]);
}

static void print_supports(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *support = &s->supports[n];
        fprintf(out, "support fix %u\n", support->fix);
        print(out, "support from", 3, support->lo);
        print(out, "support to", 3, support->hi);
        if (support->part_count)
            print(out, "support part", 6 * support->part_count, support->part[0][0]);
        if (scene_grips(support))
            print(out, "support holds", 2, (double[]){support->from, support->until});
        print_motion(&support->motion, "support", out);
    }
}

static void print_loads(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->load_count; n++) {
        print(out, "load from", 3, s->loads[n].lo);
        print(out, "load to", 3, s->loads[n].hi);
        print(out, "load force", 3, s->loads[n].force);
    }
}

/* Prints a mesh as it lies in the scene: its numbers, and a mark made from all of it. */
static void print_mesh(const struct scene_obstacle *o, FILE *out)
{
    if (o->mesh) {
        const struct body_mesh_view m = body_mesh_view(o->mesh);
        fprintf(out, "mesh %d %d %016" PRIx64 "\n", m.vertices, m.triangles, m.mark);
    } else
        fprintf(out, "mesh missing\n");
    print(out, "friction", 1, &o->friction);
}

static void print_obstacles(const struct scene *s, FILE *out)
{
    for (int n = 0; n < s->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->obstacles[n];
        const struct schema_key *kind = &scene_schema_obstacles[o->kind], *k = kind->keys;
        if (o->kind == OBSTACLE_MESH)
            print_mesh(o, out);
        for (; o->kind != OBSTACLE_MESH && k->key; k++)
            if (k->type == SCHEMA_NUMBER || k->type == SCHEMA_VECTOR)
                print(out, k == kind->keys ? kind->key : k->key,
                      k->type == SCHEMA_VECTOR ? 3 : 1,
                      (const void *)((const char *)o + k->offset));
        print_motion(&o->motion, "obstacle", out);
    }
}

/* Prints only a contact that is not all by rule. */
static void print_contact(const struct scene *s, FILE *out)
{
    const struct scene_contact *c = &s->contact;

    if (c->self || c->thickness > 0 || c->range > 0 || c->stiffness > 0 || c->friction > 0)
        print(out, "contact", 5,
              (double[]){c->self, c->thickness, c->range, c->stiffness, c->friction});
}

/* Prints only the numbers that the kind of damping has. A factor a step is a physics that
 * depends on the step. */
static void print_damping(const struct scene *s, FILE *out)
{
    const struct scene_damping *d = &s->damping;

    fprintf(out, "damping %s\n", damping_words[d->kind]);
    if (d->kind == DAMPING_RAYLEIGH)
        print(out, "rayleigh", 2, (double[]){d->alpha, d->beta});
    else if (d->kind != DAMPING_NONE)
        print(out, "value", 1, &d->value);
    if (d->kind == DAMPING_VELOCITY_SCALE)
        print(out, "step", 1, &s->step);
}

enum status truth_physics(const struct scene *s, char **text)
{
    char *result = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&result, &size);

    if (!out)
        return STATUS_MEMORY;
    print(out, "sheet", 3, (double[]){s->length, s->width, s->thickness});
    for (int k = 0; s->pattern && k < s->pattern->lines; k++)
        print(out, "line", 2 * (s->pattern->line[k + 1] - s->pattern->line[k]),
              s->pattern->at[s->pattern->line[k]]);
    if (pattern_starts_in_space(s->pattern))
        fprintf(out, "sewn %llx\n", pattern_sum(s->pattern));
    fprintf(out, "shape %s\n", scene_shape_words[s->shape]);
    if (s->shape == SCENE_CLOAK)
        print(out, "cloak", 2, (double[]){s->opening, s->flare});
    for (int k = 0; k < scene_sheets(s); k++) {
        print(out, "origin", 3, s->pose[k].origin);
        print(out, "u", 3, s->pose[k].axis_u);
        print(out, "v", 3, s->pose[k].axis_v);
        if (s->own[k].density > 0)
            print(out, "own", 3, &s->own[k].young);
    }
    print(out, "material", 3, (double[]){s->young, s->poisson, s->density});
    if (s->is_fabric) {
        print(out, "membrane", LAW_MODULI, s->fabric.membrane);
        print(out, "bending", LAW_MODULI, s->fabric.bending);
        print(out, "warp", 1, &s->fabric.warp);
        if (scene_needs(s) & SCENE_NEED_SOFTENING)
            print(out, "softening", 2, s->fabric.softening);
    }
    print(out, "gravity", 3, s->gravity);
    if (s->pressure != 0)
        print(out, "pressure", 1, &s->pressure);
    print(out, "drag", 1, &s->drag);
    if (s->drag != 0)
        print(out, "wind", 3, s->wind);
    if (s->air.density > 0)
        print(out, "air", 3, (double[]){s->air.density, s->air.drag[0], s->air.drag[1]});
    for (int n = 0; s->air.density > 0 && n < s->air.wind_count; n++)
        print(out, "blows", 4, s->air.wind[n]);
    if (scene_needs(s) & SCENE_NEED_INITIAL_MOTION) {
        print(out, "velocity", 3, s->velocity);
        print(out, "spin", 3, s->spin);
        if (scene_ripples(s)) {
            print(out, "ripple", 3, s->ripple);
            print(out, "wave", 2, (double[]){s->wave, s->seed});
        }
    }
    print_damping(s, out);
    print_supports(s, out);
    print_loads(s, out);
    print_obstacles(s, out);
    print_contact(s, out);
    if (fclose(out) != 0) {
        free(result);
        return STATUS_MEMORY;
    }
    *text = result;
    return STATUS_OK;
}

/* Returns how many sheets a text is of: each has its origin. */
static int count_sheets(const char *text)
{
    int count = 0;

    while ((text = strstr(text, "\norigin ")))
        text++, count++;
    return count;
}

/* Moves both past the lines with which they begin alike. */
static void skip_common(const char **a, const char **b)
{
    size_t line = 0;

    for (size_t n = 0; (*a)[n] && (*a)[n] == (*b)[n]; n++)
        if ((*a)[n] == '\n')
            line = n + 1;
    *a += line;
    *b += line;
}

enum { LINE = 256 };

/* Copies the first line of a text, a blank before each word, with the digits that people
 * write. */
static void tell_line(const char *text, char line[LINE])
{
    size_t used = 0;

    line[0] = '\0';
    for (size_t word; *text && *text != '\n' && used < LINE / 2; text += word) {
        char *after;
        const double value = strtod(text, &after);
        text += *text == ' ';
        word = strcspn(text, " \n");
        used +=
            (size_t)(after == text + word
                         ? snprintf(line + used, LINE - used, " %.15g", value)
                         : snprintf(line + used, LINE - used, " %.*s", (int)word, text));
    }
}

enum status truth_physics_check(const char *text, const struct scene *scene,
                                struct message *why)
{
    char *wanted SCOPED(scope_free) = NULL;
    enum status st = truth_physics(scene, &wanted);

    if (st == STATUS_OK && strcmp(text, wanted) != 0) {
        const char *other = wanted;
        char line[2][LINE];
        skip_common(&text, &other);
        tell_line(*text ? text : "nothing", line[0]);
        tell_line(*other ? other : "nothing", line[1]);
        st = status_fail(why, STATUS_UNSUPPORTED, "of other physics:%s, not%s", line[0],
                         line[1]);
    }
    return st;
}

/* --- Writing and reading --- */

/* The columns of a file; some that others lack: what is not packed, and of
 * truth_crossing_judge, whose search of all that come with the program takes a second. */
static const struct {
    int column; /* enum truth_column; -1: the error */
    const char *name, *unit;
    bool some;
} columns[] = {
#define TRUTH_COLUMN_ROW(code, name, unit)                                                 \
    {TRUTH_##code, name, unit, TRUTH_##code == TRUTH_PACKING},
    TRUTH_COLUMN_LIST(TRUTH_COLUMN_ROW)
#undef TRUTH_COLUMN_ROW
        {-1, "error", "m", false},
    {TRUTH_CROSSINGS, "crossing_pairs", "1", true},
    {TRUTH_CROSSING_DEPTH, "crossing_depth", "m", true}};
enum { COLUMNS = sizeof columns / sizeof *columns };

static double *cell(const struct truth *t, int n, int column)
{
    return column < 0 ? &t->error[n] : &t->value[n][column];
}

void truth_pack(struct truth *t, double length)
{
    for (int n = 0; n < t->claimed; n++) {
        /* no point moves by more than sqrt(3) / 2 of a step */
        const double most = fmin(t->error[n] / 10 * 2 / sqrt(3), length / 65536);
        const double step = most > 0 ? ldexp(1, ilogb(most)) : 0;
        for (int k = 0; step > 0 && k < 3 * GRID_POINTS; k++)
            t->xyz[n][k] = step * nearbyint(t->xyz[n][k] / step);
        t->value[n][TRUTH_PACKING] = step * sqrt(3) / 2;
    }
}

/* Returns whether 32-bit floats hold all positions as they are. */
static bool is_single(const struct truth *t)
{
    for (int n = 0; n < t->claimed; n++)
        for (int k = 0; k < 3 * GRID_POINTS; k++)
            if ((double)(float)t->xyz[n][k] != t->xyz[n][k] && !isnan(t->xyz[n][k]))
                return false;
    return true;
}

static enum status put_columns(struct store *store, const struct truth *made,
                               struct message *why)
{
    struct arena own SCOPED(arena_clear) = {0};
    double *column = arena_take(&own, (size_t)made->times, sizeof *column);

    for (int c = 0; c < COLUMNS; c++) {
        for (int n = 0; n < made->times; n++)
            column[n] = *cell(made, n, columns[c].column);
        if (!columns[c].some || (made->claimed && !isnan(*column)))
            CALL(store_metric(store, columns[c].name, columns[c].unit, column, made->times,
                              why));
    }
    return STATUS_OK;
}

static enum status put_all(struct store *store, const struct scene *scene,
                           const struct truth *made, struct message *why)
{
    char *physics SCOPED(scope_free) = NULL;

    CALL(truth_physics(scene, &physics));
    for (int n = 0; n < made->times; n++)
        CALL(store_frame(store, made->time[n], n < made->claimed ? made->xyz[n] : NULL,
                         NULL, NULL, why));
    CALL(put_columns(store, made, why));
    CALL(store_text(store, "note", made->source, why));
    CALL(store_text(store, "horizon", made->horizon, why));
    return store_text(store, "physics", physics, why);
}

/* Reads the run that the field is from; of a closed form the scene alone. */
static enum status read_run(const struct truth_runs *runs, const struct truth *made,
                            struct run *run, struct message *why)
{
    struct case_plan c SCOPED(case_clear) = {.path = runs->path};

    if (made->closed || made->foreign)
        return contestant_read_scene(runs->settings, runs->path, &run->scene, why);
    CALL(truth_level_settings(runs, &made->level, &c.settings, why));
    c.contestant = truth_level_contestant(&made->level);
    return run_read(run, &c, why);
}

enum status truth_file_write(const char *path, const struct truth_runs *runs,
                             const struct truth *made, struct message *why)
{
    /* The names that the file has of what is no model of ours. */
    static const struct model none = {.name = "closed_form",
                                      .title = "closed form",
                                      .source = "bench/truth/truth_closed.h"},
                              foreign = {.name = "foreign",
                                         .title = "somebody else's program",
                                         .source = "bench/truth/truth_third.h"};
    struct run run SCOPED(run_close) = {0};
    struct store *done;
    struct store *store SCOPED(store_discard_scope) = NULL;

    CALL(read_run(runs, made, &run, why));
    CALL(store_create(path,
                      &(struct store_run){.scene = &run.scene,
                                          .model = made->closed    ? &none
                                                   : made->foreign ? &foreign
                                                                   : run.model,
                                          .discretization = &run.discretization,
                                          .single = is_single(made),
                                          .packed = true},
                      &store, why));
    CALL(put_all(store, &run.scene, made, why));
    done = store, store = NULL;
    return store_close(done, why);
}

static enum status read_columns(struct store_read *file, struct truth *made)
{
    double *column;
    int rows, width;

    for (int c = 0; c < COLUMNS; c++) {
        char name[64];
        snprintf(name, sizeof name, "metrics/%s", columns[c].name);
        if (columns[c].some && !store_read_has(file, name))
            continue;
        CALL(store_read_array(file, name, &column, &rows, &width, NULL));
        if (rows != made->times || width != 1)
            CALL(STATUS_INPUT);
        for (int n = 0; n < rows; n++)
            *cell(made, n, columns[c].column) = column[n];
    }
    return STATUS_OK;
}

/* Reads what room[size] takes of a text; of a file without it `else_say`, if not NULL. */
static enum status read_text(struct store_read *file, const char *group, const char *key,
                             const char *else_say, char *room, size_t size)
{
    char *text;
    const enum status st = store_read_text(file, group, key, &text, NULL);

    snprintf(room, size, "%s", st == STATUS_OK ? text : else_say ? else_say : "");
    return else_say ? STATUS_OK : st;
}

static enum status read_made(struct store_read *file, struct truth *made)
{
    double *time;
    char *text;
    int times, width, claimed = store_read_frames(file);

    CALL(store_read_text(file, "/", "physics", &text, NULL));
    CALL(store_read_array(file, "time", &time, &times, &width, NULL));
    CALL(claimed > times ? STATUS_INPUT : STATUS_OK);
    truth_init(made, times, claimed, time);
    made->physics = arena_print(&made->arena, "%s", text);
    CALL(read_columns(file, made));
    for (int n = 0; n < claimed; n++)
        CALL(store_read_frame(file, n, made->xyz[n], NULL));
    CALL(read_text(file, "/", "note", NULL, made->source, sizeof made->source));
    CALL(read_text(file, "/", "horizon", NULL, made->horizon, sizeof made->horizon));
    CALL(read_text(file, "provenance", "commit", "unknown", made->commit,
                   sizeof made->commit));
    return read_text(file, "provenance", "changed_files", "unknown", made->changed,
                     sizeof made->changed);
}

/* Reads a file without the third beside it. */
static enum status read_alone(const char *path, struct truth *made, struct message *why)
{
    struct store_read *file = NULL;
    enum status st;

    memset(made, 0, sizeof *made);
    TRY(store_read_open(path, &file, why));
    st = read_made(file, made);
    TRY(st == STATUS_OK || st == STATUS_MEMORY
            ? st
            : status_fail(why, STATUS_INPUT, "%s: is not a stored truth", path));
out:
    if (st != STATUS_OK)
        truth_clear(made);
    store_read_close(file);
    return st;
}

enum status truth_file_third(const char *path, char *third, size_t size,
                             struct message *why)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;

    if (snprintf(third, size, "%.*s/third/%s", slash ? (int)(slash - path) : 1,
                 slash ? path : ".", name) < (int)size)
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT, "%s: the name is too long", path);
}

/* Judges a truth by the third beside it, if it is of the same physics. */
static enum status judge_by_third(const char *path, struct truth *made, struct message *why)
{
    struct truth third SCOPED(truth_clear) = {0};
    char file[4096];
    struct stat there;

    CALL(truth_file_third(path, file, sizeof file, why));
    if (stat(file, &there) != 0)
        return STATUS_OK;
    CALL(read_alone(file, &third, why));
    if (strcmp(third.physics, made->physics) == 0)
        truth_third_judge(&third, made);
    else
        snprintf(made->third, sizeof made->third,
                 "not compared, as it is of other physics");
    return STATUS_OK;
}

/* Reads a file; `search`: for crossings, too. */
static enum status read_judged(const char *path, bool search, struct truth *made,
                               struct message *why)
{
    enum status st;

    TRY(read_alone(path, made, why));
    TRY(judge_by_third(path, made, why));
    made->outlined = strstr(made->physics, "\nline ");
    st = search ? truth_crossing_judge(made, count_sheets(made->physics)) : STATUS_OK;
    if (st == STATUS_INPUT)
        status_fail(why, st, "%s: has positions that are no finite numbers", path);
out:
    if (st != STATUS_OK)
        truth_clear(made);
    return st;
}

enum status truth_file_read(const char *path, struct truth *made, struct message *why)
{
    return read_judged(path, true, made, why);
}

/* Finds the truth of a name or a path; `search`: for crossings, too. */
static enum status find(const char *name, bool search, const struct scene *scene,
                        struct truth *made, struct message *why)
{
    char *path = NULL;
    struct message other = {""};
    enum status st;

    memset(made, 0, sizeof *made);
    st = named_file_find(&truth_file_kind, name, &path, why);
    if (st != STATUS_OK)
        return st == STATUS_INPUT ? STATUS_FILE : st;
    TRY(read_judged(path, search, made, why));
    st = truth_physics_check(made->physics, scene, &other);
    if (st == STATUS_UNSUPPORTED)
        status_fail(why, st, "the stored truth of %s is %s", name, other.text);
out:
    if (st != STATUS_OK)
        truth_clear(made);
    free(path);
    return st;
}

static bool is_none(enum status st)
{
    return st == STATUS_FILE || st == STATUS_UNSUPPORTED;
}

enum status truth_file_find(const char *name, const struct scene *scene, struct truth *made,
                            struct message *why)
{
    const bool named = !strchr(name, '/');
    const enum status st = find(name, named, scene, made, why);
    struct message said = {""};
    char left[4096];

    if (!named || !is_none(st))
        return st;
    snprintf(left, sizeof left, TRUTH_FILE_LEFT "/%s%s", name, truth_file_kind.ending);
    const enum status here = find(left, true, scene, made, &said);
    return is_none(here) ? st : here ? status_fail(why, here, "%s", said.text) : here;
}

static char *describe(const char *path)
{
    struct truth made SCOPED(truth_clear) = {0};
    struct message why;
    char text[sizeof made.source + 64];

    if (truth_file_read(path, &made, &why) != STATUS_OK)
        return strdup(why.text);
    snprintf(text, sizeof text, "to %.3g s; %s",
             made.claimed ? made.time[made.claimed - 1] : 0, made.source);
    return strdup(text);
}

const struct named_file_kind truth_file_kind = {
    .what = "truth",
    .ending = ".h5",
    .environment = "CLOTHBENCH_TRUTHS",
    .from_program = TRUTHS_FROM_PROGRAM,
    .in_source = TRUTHS_IN_SOURCE,
    .describe = describe,
};
