/* Malformed scenes and settings: each is refused with one sentence, at the right line, and
 * leaves nothing behind. The corpus is tests/bad_scenes/, the lines are in its
 * expected.csv.
 */
#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include "models/reader/scene_file.h"
#include "tests/scratch.h"
#include "tests/text.h"

#define FOLDER SOURCE_DIR "/tests/bad_scenes/"

static const char GOOD[] = "name: good\n"
                           "source: a test\n"
                           "sheet: {length: 1, width: 1, thickness: 0.01}\n"
                           "material: {young: 1e5, poisson: 0.3, density: 0.5}\n"
                           "damping: {kind: mass, value: 1}\n"
                           "supports: [{at: {u: 0}, fix: xyz}]\n"
                           "time: {step: 0.1, end: 1}\n"
                           "snapshots: [0.5]\n";

/* One printable sentence that begins with what is wrong, and a scene all-zero. */
static void check_refusal(const char *what, enum status st, enum status want_st,
                          const struct scene *scene, const struct message *why,
                          const char *beginning)
{
    static const struct scene zero;
    const size_t length = strlen(why->text);
    bool fine = st == want_st && !memcmp(scene, &zero, sizeof zero);

    fine = fine && !strncmp(why->text, beginning, strlen(beginning));
    fine = fine && length > strlen(beginning) + 5 && length < sizeof why->text - 1;
    for (size_t i = 0; i < length; i++)
        fine = fine && (unsigned char)why->text[i] >= ' ';
    CHECK_SAY(fine, "%s: wanted '%s...', got status %d '%s'", what, beginning, st,
              why->text);
}

static enum status read_scene(const char *path, struct scene *scene, struct message *why)
{
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    enum status st;

    memset(scene, 'x', sizeof *scene);
    st = scene_file_read(path, 0, NULL, scene, &d, why);
    discretization_clear(&d);
    return st;
}

static int corpus_size(void)
{
    DIR *directory = opendir(FOLDER);
    const struct dirent *file;
    int count = 0;

    while (directory && (file = readdir(directory)))
        count += strstr(file->d_name, ".yaml") != NULL;
    if (directory)
        closedir(directory);
    return count;
}

static void check_corpus(void)
{
    FILE *csv = fopen(FOLDER "expected.csv", "r");
    char row[512];
    int count = 0;

    REQUIRE(csv);
    while (fgets(row, sizeof row, csv)) {
        char file[128], path[512], beginning[600];
        struct scene scene;
        struct message why = {""};
        enum status st;
        int line;

        if (*row == '#')
            continue;
        REQUIRE(sscanf(row, "%127[^,],%d", file, &line) == 2);
        snprintf(path, sizeof path, FOLDER "%s", file);
        snprintf(beginning, sizeof beginning, "%s:%d: ", path, line);
        st = read_scene(path, &scene, &why);
        check_refusal(file, st, STATUS_INPUT, &scene, &why, beginning);
        count++;
    }
    fclose(csv);
    CHECK(count >= 60);
    CHECK(count == corpus_size());
}

static const char *const BAD_SETTINGS[] = {
    "",
    "=3",
    "material.young",
    ".young=3",
    "material.young.=3",
    "material young=3",
    "supports[]=3",
    "supports[-1].fix=x",
    "supports[0]fix=x",
    "a.a.a.a.a.a.a.a.a.a.a.a.a=3",
    "material.young=",
    "material.young=[1",
    "material.young=: :",
    "material.young=*a",
    "material.young=1\nmaterial.density=2",
    "source=a\xc2\x85"
    "b",
    "material.young=\xff",
    "material.young.x=1",
    "name.x=1",
    "supports[1].fix=x",
    "supports[99999999999999999999].fix=x",
    "supports.fix=x",
    "material[0]=1",
    "obstacles[0].plane.point=[0,0,0]",
    "obstacles=[{box: {center: [0,0,5], size: [1,0,1]}}]",
    "obstacles=[{box: {center: [0,0,5], size: [1,1,1], u: [2,0,0]}}]",
    "obstacles=[{box: {center: [0,0,5], size: [1,1,1], v: [0.6,0.8,0]}}]",
    "obstacles=[{box: {center: [0.5,0.5,0.004], size: [1,1,0.1]}}]",
    "obstacles=[{capsule: {from: [0,0,5], radius: 1}}]",
    "obstacles=[{capsule: {from: [0,0,5], to: [0,0,6], radius: -1}}]",
    "obstacles=[{capsule: {from: [0.2,0.4,5], to: [0.2,0.4,0.2], radius: 0.3}}]",
    "obstacles=[{mesh: {file: body.stl}}]",
    "obstacles=[{mesh: {file: body.obj, scale: 0}}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: []}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: [[1,0,0,0],[1,0,0,1]]}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: [[0,0,0,2]]}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,0,1]}}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,0,0], about: "
    "[0,0,0], angles: [[0,1]]}}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [1,0,0], about: "
    "[0,0,0], angles: [[0,1,2]]}}]",
    "obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,2,0], about: "
    "[0.5,0,-1], angles: [[0,0],[0.5,90],[0.25,0]]}}]",
    "sheets=[{origin: [0,0,0]}]",
    "sheets=[{origin: [0,0,0]},{u: [1,0,0]}]",
    "sheets=[{origin: [0,0,0]},{origin: [0,0,1],u: [2,0,0]}]",
    "sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {young: 1}}]",
    "sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {young: 1,poisson: 0.5,density: "
    "1}}]",
    "sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {fabric: denim}}]",
    "supports=[{at: {sheet: 2, u: 0}, fix: x}]",
    "loads=[{at: {sheet: 0}, force: [1,0,0]}]",
    "contact.self=yes",
    "contact.thickness=-1",
    "contact.range=0.01",
    "contact={thickness: 0.002, range: 0.003}",
    "contact.thickness=1e-300",
    "contact.stiffness=nan",
    "contact.friction=-0.1",
    "discretization=3",
    "discretization.points=[10,10,2,1]",
    "discretization.points=[10,10,0]",
    "discretization.points=[10,1e1,2]",
    "discretization.points=[10,2.5,2]",
    "discretization.points=[10000,10000,10000]",
    "discretization.degree=[0,2,1]",
    "discretization.gauss=[17,2,1]",
    "discretization.knots_u=[0,0,0.5,0.4,1,1]",
    "discretization.knots_u=[0,0,2,2]",
    "discretization.knots_x=[0,0,1,1]",
    "discretization.weights=[1,0]",
    "discretization.kinematics=quantum",
    "discretization.remedy=unknown",
    "discretization.solver=lu",
    "discretization.unknowns=[points]",
    "discretization.parameters=mine",
    "discretization.integrator=rk4",
    "discretization.substeps=1.5",
    "discretization.iterations=-1",
    "discretization.tolerance=2",
    "discretization.bending=magic",
    "discretization[0]=1"};

static void check_settings(void)
{
    for (size_t i = 0; i < sizeof BAD_SETTINGS / sizeof *BAD_SETTINGS; i++) {
        const char *setting = BAD_SETTINGS[i];
        struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
        struct scene scene;
        struct message why = {""};
        char beginning[256];
        enum status st;

        snprintf(beginning, sizeof beginning, "--set %s: ", setting);
        for (char *c = beginning; *c; c++)
            *c = (unsigned char)*c < ' ' ? '?' : *c;
        st = scene_file_parse("good", GOOD, strlen(GOOD), 1, &setting, &scene, &d, &why);
        check_refusal(setting, st, STATUS_INPUT, &scene, &why, beginning);
        CHECK(d.points[0] == 10 && d.degree[0] == 2 && !d.knots[0] && !d.weights);
        discretization_clear(&d);
    }
}

/* `head`, `count` times `item`, `tail` as a scene in memory. */
static void check_huge(const char *head, const char *item, int count, const char *tail)
{
    const size_t room = strlen(GOOD) + strlen(head) + strlen(tail) + 1;
    char *text = malloc(room + (size_t)count * strlen(item)), *end = text;
    struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
    struct scene scene;
    struct message why = {""};
    enum status st;

    REQUIRE(text);
    end = stpcpy(stpcpy(end, GOOD), head);
    for (int i = 0; i < count; i++)
        end = stpcpy(end, item);
    stpcpy(end, tail);
    st = scene_file_parse("huge", text, strlen(text), 0, NULL, &scene, &d, &why);
    check_refusal(item, st, STATUS_INPUT, &scene, &why, "huge:");
    free(text);
    discretization_clear(&d);
}

static void check_sizes(void)
{
    check_huge("# ", "a long comment ", 80000, "");
    check_huge("", "{", 500000, "");
    check_huge("obstacles: ", "[", 500000, "");
    check_huge("obstacles: ", "- ", 300000, "");
    check_huge("obstacles: [", "{},", 300000, "]");
    check_huge("gravity: [", "1,", 500000, "]");
    check_huge("obstacles: ", "x", 900000, "");
    check_huge("", "? ", 400000, "");
    check_huge("pose: {", "a,", 400000, "}");
}

static void check_files(void)
{
    const char *path = scratch_path("none.yaml");
    char far[1280];
    struct scene scene;
    struct message why = {""};
    enum status st;

    st = read_scene(scratch, &scene, &why);
    check_refusal("directory", st, STATUS_FILE, &scene, &why, scratch);
    st = read_scene(path, &scene, &why);
    check_refusal("missing", st, STATUS_FILE, &scene, &why, path);

    path = scratch_path("pipe.yaml");
    REQUIRE(mkfifo(path, 0600) == 0); /* nobody writes: opening it would wait for ever */
    st = read_scene(path, &scene, &why);
    check_refusal("pipe", st, STATUS_FILE, &scene, &why, path);

    /* Names that would break a line or a sentence. */
    path = scratch_path("a\nb.yaml");
    text_write(path, "");
    st = read_scene(path, &scene, &why);
    check_refusal("line break", st, STATUS_INPUT, &scene, &why,
                  scratch_path("a?b.yaml:1: "));
    snprintf(far, sizeof far, "%s/%0900d", scratch, 0);
    st = read_scene(far, &scene, &why);
    CHECK(st == STATUS_FILE && *why.text);

    st = read_scene("/dev/zero", &scene, &why);
    check_refusal("endless", st, STATUS_FILE, &scene, &why, "/dev/zero: ");
    st = read_scene("", &scene, &why);
    check_refusal("no name", st, STATUS_FILE, &scene, &why, "");
}

int main(void)
{
    scratch_open();
    check_corpus();
    check_settings();
    check_sizes();
    check_files();
    return check_result();
}
