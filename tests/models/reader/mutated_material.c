/* Mutated blocks of material, as a file's and as a setting: each is refused with a sentence
 * that begins with the line, or with --set, or is read; of those that are read, one in
 * EVERY moves for a few steps, and then is finite or has died of a reason.
 *   mutated_material [COUNT] */
#include <stdint.h>

#include "models/reader/scene_file.h"
#include "tests/opened_run.h"

enum { COUNT = 10000, EVERY = 20, ROOM = 512, MOST_TOKENS = 64, STEPS = 3 };

static const char *const blocks[] = {
    "{young: 1e5, poisson: 0.3, density: 0.5}",
    "{fabric: denim, warp: 30}",
    "{membrane: [2000, 5000, 800, 300], bending: [1e-5, 4e-5, 4e-6, 6e-6], "
    "areal_density: 0.1, warp: 90}",
    "{fabric: feng_421, softening: [-5.06e-8, -2.19e-8], warp: 30}",
};
/* Words that take the place of others. */
static const char *const words[] = {
    "0",       "-1",      "1e-9",    "1e-300",   "1e300",     "1e15",  "nan",
    "inf",     "-0.0",    "359.999", "89.99999", "0x10",      "1e-5",  "5000",
    "denim",   "nylon",   "~",       "''",       "[]",        "{}",    "[1, 2, 3]",
    "fabric",  "young",   "warp",    "membrane", "bending",   ",",     ":",
    "]",       "}",       "&a",      "*a",       "#",         "\xff",  "areal_density",
    "poisson", "density", "0.49",    "800",      "-800",      "1e-12", "3162.2",
    "-1e-8",   "[-1, 0]", "law",     "mean",     "softening",
};
static const char punctuation[] = "{}[],: ";

static uint64_t seed = 31;

/* Returns a whole number from 0 to below - 1. */
static size_t any(size_t below)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (size_t)(seed >> 33) % below;
}

/* Replaces `old` bytes at `at` by a text; leaves what would not fit. */
static void splice(char text[ROOM], size_t at, size_t old, const char *put, size_t size)
{
    const size_t length = strlen(text);

    if (length - old + size >= ROOM)
        return;
    memmove(text + at + size, text + at + old, length - at - old + 1);
    memcpy(text + at, put, size);
}

/* Finds the words of a block. */
static int tokens_of(const char *text, size_t at[MOST_TOKENS], size_t size[MOST_TOKENS])
{
    int count = 0;

    for (const char *c = text; *c && count < MOST_TOKENS;) {
        c += strspn(c, punctuation);
        at[count] = (size_t)(c - text);
        size[count] = strcspn(c, punctuation);
        c += size[count];
        count += size[count] > 0;
    }
    return count;
}

/* Changes a word, a byte, or the place of a word. */
static void mutate(char text[ROOM])
{
    size_t at[MOST_TOKENS], size[MOST_TOKENS];
    const int count = tokens_of(text, at, size);
    const char byte = (char)(32 + any(95));

    if (!count || any(4) == 0) {
        const size_t place = any(strlen(text) + 1);
        splice(text, place, text[place] && any(2), &byte, any(2));
        return;
    }
    const size_t n = any((size_t)count), other = any((size_t)count);
    const char *word = words[any(sizeof words / sizeof *words)];
    char copy[ROOM];
    snprintf(copy, sizeof copy, "%.*s", (int)size[other], text + at[other]);
    if (any(4) == 0)
        word = copy;
    splice(text, at[n], size[n], word, strlen(word));
}

/* Checks that a refusal is one printable sentence that begins where it should. */
static void check_sentence(const char *text, enum status st, const struct message *why,
                           const char *beginning)
{
    bool fine = st == STATUS_INPUT && !strncmp(why->text, beginning, strlen(beginning)) &&
                strlen(why->text) > strlen(beginning) + 8;

    for (const char *c = why->text; *c; c++)
        fine = fine && (unsigned char)*c >= ' ';
    CHECK_SAY(fine, "%s: status %d, '%s'", text, st, why->text);
}

/* Tells whether moduli have an energy above 0 in every strain. */
static bool is_sound(const double m[LAW_MODULI])
{
    return m[LAW_WARP] > 0 && m[LAW_WEFT] > 0 && m[LAW_SHEAR] > 0 &&
           m[LAW_CROSS] * m[LAW_CROSS] < m[LAW_WARP] * m[LAW_WEFT];
}

/* Tells whether a scene with the block in its file is read. */
static bool is_read(const char *text)
{
    char file[2 * ROOM];
    struct scene scene;
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    struct message why = {""};

    snprintf(
        file, sizeof file,
        "name: mutated\nsource: a test\nsheet: {length: 1, width: 1%s}\n"
        "supports: [{at: {u: 0}, fix: xyz}]\ntime: {step: 0.1, end: 1}\nmaterial: %s\n",
        strstr(text, "young") ? ", thickness: 0.01" : "", text);
    const enum status st =
        scene_file_parse("mutated", file, strlen(file), 0, NULL, &scene, &d, &why);
    if (st != STATUS_OK)
        check_sentence(text, st, &why, "mutated:");
    else
        CHECK(scene.thickness > 0 && scene.density > 0 && scene.young > 0 &&
              scene.poisson < 0.5 &&
              (!scene.is_fabric ||
               (is_sound(scene.fabric.membrane) && is_sound(scene.fabric.bending) &&
                scene.fabric.softening[0] <= 0 && scene.fabric.softening[1] <= 0)));
    scene_clear(&scene);
    discretization_clear(&d);
    return st == STATUS_OK;
}

/* Moves a sheet of such material for some steps. */
static void move(const char *text, const char *model)
{
    char material[ROOM + 16];
    struct case_plan plan = {.path = "edge_drop"};
    struct run run;
    struct message why = {""};
    struct counters work = {0};
    double xyz[3] = {0};

    snprintf(material, sizeof material, "material=%s", text);
    REQUIRE(contestant_find(model, &plan.contestant, NULL) == STATUS_OK);
    settings_list(&plan.settings, 3,
                  (const char *const[]){material, "discretization.points=[5,5]",
                                        "time={step: 0.001, end: 0.01}"});
    enum status st = run_read(&run, &plan, &why);
    if (st != STATUS_OK)
        check_sentence(text, st, &why, "--set ");
    else if ((st = run_build(&run, &why)) != STATUS_OK)
        CHECK((st == STATUS_UNSUPPORTED || st == STATUS_INPUT) && strlen(why.text) > 8);
    for (int n = 0; st == STATUS_OK && n < STEPS; n++)
        st = run.model->advance(run.state, &work);
    if (run.state && st == STATUS_OK) {
        run.model->probe(run.state, 1, (double[]){1, 0.5, 0.5}, xyz);
        CHECK(isfinite(xyz[0] + xyz[1] + xyz[2]));
    } else if (run.state)
        CHECK(status_is_death(st));
    run_close(&run);
    settings_clear(&plan.settings);
}

int main(int argc, char **argv)
{
    const int count = argc == 2 ? atoi(argv[1]) : COUNT;
    int read = 0;

    for (int n = 0; n < count; n++) {
        char text[ROOM];
        snprintf(text, sizeof text, "%s", blocks[any(sizeof blocks / sizeof *blocks)]);
        for (size_t k = 1 + any(3); k > 0; k--)
            mutate(text);
        if (is_read(text) && ++read % EVERY == 0)
            move(text, read % (2 * EVERY) ? "shell_3" : "triangles");
    }
    printf("%d of %d are read\n", read, count);
    /* too few of either and the mutations test nothing */
    CHECK(read > count / 50 && read < count / 2);
    return check_result();
}
