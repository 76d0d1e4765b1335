/* Compares explicit springs on small and large nets with the memory's bandwidth. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

#include "bench/speed/bench.h"
#include "models/clones.h"
#include "models/room.h"

/* Points a side: the first net fits into a core's own cache, the last does not. */
static const int sides[] = {16, 100, 300};
enum { SIDES = sizeof sides / sizeof *sides, PRECISIONS = 2, CASES = SIDES * PRECISIONS };

static const struct {
    const char *contestant, *word;
    size_t size;
} precisions[PRECISIONS] = {{"mass_spring_single", "single", sizeof(float)},
                            {"mass_spring_leapfrog", "double", sizeof(double)}};

/* Numbers per node that a step must read or write: positions, velocities, both ways; and
 * that a net holds: positions before and after, velocities. Coefficients belong to a strip,
 * and strips share them (models/net/spring_sweep.h). */
enum { MOVED = 12, HELD = 9 };

/* Numbers per element that a triad, a = b + s c, must read or write. */
enum { TRIAD_MOVED = 3 };

/* Arrays to lie in memory are BEYOND times the last cache, within these bounds [bytes]. */
static const double BEYOND = 4, LEAST_MEMORY = 192e6, MOST_MEMORY = 1.6e9;

/* A triad, for the sustainable rate of memory as McCalpin measures it (IEEE TCCA
 * Newsletter, 1995). */
struct triad {
    size_t count;
    double *a, *b, *c;
    void *room;
};

CLONES static void run_triad(size_t count, double *restrict a, const double *restrict b,
                             const double *restrict c)
{
    for (size_t n = 0; n < count; n++)
        a[n] = b[n] + 3 * c[n];
}

static enum status call_triad(void *triad)
{
    const struct triad *t = triad;

    run_triad(t->count, t->a, t->b, t->c);
    return STATUS_OK;
}

static enum status make_triad(struct triad *t, double bytes)
{
    enum status st;

    t->count = (size_t)(bytes / (TRIAD_MOVED * sizeof(double))) + 1;
    TRY(room_cut(&t->room, ROOM(t->a, t->count), ROOM(t->b, t->count),
                 ROOM(t->c, t->count)));
    for (size_t n = 0; n < t->count; n++) /* else its pages are one */
        t->a[n] = 1, t->b[n] = 2, t->c[n] = 3;
out:
    return st;
}

/* A net that is moved frame by frame. */
struct net {
    char name[SAMPLES_NAME];
    struct run run;
    struct counters work;
    double frames;
    struct triad triad; /* of as many bytes */
};

static enum status call_frame(void *net)
{
    struct net *n = net;

    n->frames++;
    return n->run.model->advance(n->run.state, &n->work);
}

static void name_case(int k, char name[SAMPLES_NAME])
{
    const int side = sides[k / PRECISIONS];

    snprintf(name, SAMPLES_NAME, "%dx%d %s", side, side, precisions[k % PRECISIONS].word);
}

static double held_bytes(int k)
{
    const double side = sides[k / PRECISIONS];

    return side * side * HELD * (double)precisions[k % PRECISIONS].size;
}

static enum status open_net(struct net *net, const char *path, int k, struct message *why)
{
    const struct contestant *who = NULL;
    const int side = sides[k / PRECISIONS];
    struct settings settings = {0};
    enum status st;

    name_case(k, net->name);
    TRY(contestant_find(precisions[k % PRECISIONS].contestant, &who, why));
    contestant_points(who, side, side, &settings);
    settings_set(&settings, "damping={kind: none}");
    TRY(run_open(&net->run, &(struct run_plan){path, who, &settings, 0}, why));
    TRY(make_triad(&net->triad, held_bytes(k)));
out:
    settings_clear(&settings);
    return st;
}

static double memory_bytes(bool quick)
{
    const long cache = sysconf(_SC_LEVEL3_CACHE_SIZE);

    return quick || cache <= 0
               ? LEAST_MEMORY
               : fmin(MOST_MEMORY, fmax(LEAST_MEMORY, BEYOND * (double)cache));
}

static enum status sample(struct bench *b, struct message *why)
{
    struct net *nets = calloc(CASES, sizeof *nets);
    struct triad memory = {0};
    struct samples_task tasks[2 * CASES + 1];
    const int count = b->quick ? CASES - PRECISIONS : CASES;
    enum status st = nets ? STATUS_OK : STATUS_MEMORY;
    int task = 0;

    TRY(st);
    TRY(make_triad(&memory, memory_bytes(b->quick)));
    tasks[task++] = (struct samples_task){"memory", "triad", call_triad, NULL, &memory};
    for (int k = 0; k < count; k++) {
        struct net *n = &nets[k];
        TRY(open_net(n, b->path, k, why));
        tasks[task++] = (struct samples_task){n->name, "frame", call_frame, NULL, n};
        tasks[task++] =
            (struct samples_task){n->name, "triad", call_triad, NULL, &n->triad};
    }
    TRY(samples_time(&b->samples, b->quick, task, tasks));
    samples_add(&b->samples, "memory", "elements", (double)memory.count);
    samples_add(&b->samples, "memory", "cache", (double)sysconf(_SC_LEVEL3_CACHE_SIZE));
    for (int k = 0; k < count; k++) {
        samples_add(&b->samples, nets[k].name, "elements", (double)nets[k].triad.count);
        samples_add(&b->samples, nets[k].name, "steps",
                    (double)nets[k].work.substeps / nets[k].frames);
    }
out:
    for (int k = 0; nets && k < CASES; k++) {
        free(nets[k].triad.room);
        run_close(&nets[k].run);
    }
    free(memory.room);
    free(nets);
    return st;
}

/* Returns the bytes a second of a triad as STREAM counts them: without the lines that are
 * only read because they will be written. */
static double triad_rate(const struct samples *s, const char *name)
{
    return TRIAD_MOVED * sizeof(double) * samples_number(s, name, "elements") /
           samples_of(s, name, "triad").median;
}

static void add_row(struct table *t, const struct bench *b, int k)
{
    const int side = sides[k / PRECISIONS];
    const double bytes = MOVED * (double)precisions[k % PRECISIONS].size;
    char name[SAMPLES_NAME];

    name_case(k, name);
    const struct clock_summary s = samples_of(&b->samples, name, "frame");
    if (!s.count)
        return;
    const double steps = samples_number(&b->samples, name, "steps");
    const double each = s.median / (steps * side * side), rate = bytes / each;
    table_line(t, "%dx%d|%s|%.0f|%.3g|%.3g|%.0f|%.3g|%.3g|%.2g|%.2g|%d", side, side,
               precisions[k % PRECISIONS].word, steps, 1e-6 * held_bytes(k), 1e9 * each,
               bytes, 1e-9 * rate, 1e-9 * triad_rate(&b->samples, name),
               100 * rate / triad_rate(&b->samples, name),
               100 * rate / triad_rate(&b->samples, "memory"), s.count);
}

static enum status print(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"precision", NULL, TABLE_LEFT},
                                                  {"steps", "a frame"},
                                                  {"held", "MB"},
                                                  {"node and step", "ns"},
                                                  {"moved", "B"},
                                                  {"rate", "GB/s"},
                                                  {"triad", "GB/s"},
                                                  {"of it", "%"},
                                                  {"of memory's", "%"},
                                                  {"repeats"}};
    struct table *t =
        TABLE_OF(columns, "Explicit springs beside the rate of memory, one thread");

    (void)why;
    for (int k = 0; k < CASES; k++)
        add_row(t, b, k);
    table_note(t,
               "Leapfrog on edge_drop, undamped. The column `moved` counts what a step "
               "must read and write for a node, positions and velocities, %d numbers; "
               "neighbours and coefficients stay in cache. The triad is a = b + 3 c "
               "(STREAM) on as many bytes as the net holds; near 100 %% of it the net "
               "waits for memory, far below it computes.",
               MOVED);
    table_note(t, "Memory's: a triad on %.3g MB, %.3g GB/s; the last cache has %.3g MB.",
               1e-6 * TRIAD_MOVED * sizeof(double) *
                   samples_number(&b->samples, "memory", "elements"),
               1e-9 * triad_rate(&b->samples, "memory"),
               1e-6 * samples_number(&b->samples, "memory", "cache"));
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_bandwidth = {
    .item = {"bandwidth", "explicit springs on nets up to 300x300: how near memory's rate"},
    .sample = sample,
    .print = print};
