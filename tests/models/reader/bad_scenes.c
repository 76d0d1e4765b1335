/* Malformed scenes and settings: each is refused with one sentence, at the right line, and
 * leaves nothing behind. The corpus is tests/bad_scenes/, what is expected of it is in its
 * expected.csv: file,line,part of the sentence. */
#include <dirent.h>
#include <sys/stat.h>
#include <unistd.h>

#include "models/reader/scene_file.h"
#include "tests/scratch.h"

#define FOLDER SOURCE_DIR "/tests/bad_scenes/"

static const char GOOD[] = "name: good\n"
                           "source: a test\n"
                           "sheet: {length: 1, width: 1, thickness: 0.01}\n"
                           "material: {young: 1e5, poisson: 0.3, density: 0.5}\n"
                           "damping: {kind: mass, value: 1}\n"
                           "supports: [{at: {u: 0}, fix: xyz}]\n"
                           "time: {step: 0.1, end: 1}\n"
                           "snapshots: [0.5]\n";

/* One printable sentence that begins and goes on as wanted, and a scene all-zero. */
static void check_refusal(const char *what, enum status st, enum status want_st,
                          const struct scene *scene, const struct message *why,
                          const char *beginning, const char *part)
{
    static const struct scene zero;
    const size_t length = strlen(why->text);
    bool fine = st == want_st && !memcmp(scene, &zero, sizeof zero);

    fine = fine && !strncmp(why->text, beginning, strlen(beginning));
    fine = fine && strstr(why->text + strlen(beginning), part);
    fine = fine && length > strlen(beginning) + 5 && length < sizeof why->text - 1;
    for (size_t i = 0; i < length; i++)
        fine = fine && (unsigned char)why->text[i] >= ' ';
    if (!CHECK(fine))
        printf("  %s: wanted '%s...%s...', got status %d '%s'\n", what, beginning, part, st,
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
        int line, used;

        row[strcspn(row, "\n")] = '\0';
        if (*row == '#')
            continue;
        REQUIRE(sscanf(row, "%127[^,],%d,%n", file, &line, &used) == 2);
        snprintf(path, sizeof path, FOLDER "%s", file);
        snprintf(beginning, sizeof beginning, "%s:%d: ", path, line);
        st = read_scene(path, &scene, &why);
        check_refusal(file, st, STATUS_INPUT, &scene, &why, beginning, row + used);
        count++;
    }
    fclose(csv);
    CHECK(count >= 60);
    CHECK(count == corpus_size());
}

static const struct {
    const char *setting, *part;
} BAD_SETTINGS[] = {
    {"", "write KEY=VALUE"},
    {"=3", "write KEY=VALUE"},
    {"material.young", "write KEY=VALUE"},
    {".young=3", "write KEY=VALUE"},
    {"material.young.=3", "write KEY=VALUE"},
    {"material young=3", "write KEY=VALUE"},
    {"supports[]=3", "write KEY=VALUE"},
    {"supports[-1].fix=x", "write KEY=VALUE"},
    {"supports[0]fix=x", "write KEY=VALUE"},
    {"a.a.a.a.a.a.a.a.a.a.a.a.a=3", "write KEY=VALUE"},
    {"material.young=", "empty"},
    {"material.young=[1", "not YAML"},
    {"material.young=: :", "not YAML"},
    {"material.young=*a", "an anchor"},
    {"material.young=-5", "young is '-5'"},
    {"material.young=1\nmaterial.density=2", "a line break"},
    {"source=a\xc2\x85"
     "b",
     "a line break"},
    {"material.young=\xff", "not a text in UTF-8"},
    {"material.yuong=1", "did you mean 'young'"},
    {"material.young.x=1", "young is '1e5'; it has no keys"},
    {"material={young: 1}", "lacks the key 'poisson'"},
    {"name.x=1", "name is 'good'; it has no keys"},
    {"supports[1].fix=x", "supports has 1 elements"},
    {"supports[99999999999999999999].fix=x", "supports has 1 elements"},
    {"supports.fix=x", "supports is a list of 1; it has no keys"},
    {"material[0]=1", "material is a section; it has no elements"},
    {"obstacles[0].plane.point=[0,0,0]", "it has no elements"},
    {"obstacles=[{box: {center: [0,0,5], size: [1,0,1]}}]", "size holds '0'"},
    {"obstacles=[{box: {center: [0,0,5], size: [1,1,1], u: [2,0,0]}}]",
     "box axis u has length 2"},
    {"obstacles=[{box: {center: [0,0,5], size: [1,1,1], v: [0.6,0.8,0]}}]",
     "box axes u and v have the product 0.6"},
    {"obstacles=[{box: {center: [0.5,0.5,0.004], size: [1,1,0.1]}}]",
     "reaches 0.051 m into obstacle 0"},
    {"obstacles=[{capsule: {from: [0,0,5], radius: 1}}]", "capsule lacks the key 'to'"},
    {"obstacles=[{capsule: {from: [0,0,5], to: [0,0,6], radius: -1}}]", "radius is '-1'"},
    {"obstacles=[{capsule: {from: [0.2,0.4,5], to: [0.2,0.4,0.2], radius: 0.3}}]",
     "reaches 0.1"},
    {"obstacles=[{mesh: {at: [0,0,5]}}]", "mesh lacks the key 'file'"},
    {"obstacles=[{mesh: {file: body.stl}}]", "must name an OBJ file"},
    {"obstacles=[{mesh: {file: body.obj, scale: 0}}]", "scale is '0'"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: []}]",
     "path is an empty list"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: [[1,0,0,0],[1,0,0,1]]}]",
     "path has time 1 after 1"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, path: [[0,0,0,2]]}]",
     "reaches 1 m into obstacle 0"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,0,1]}}]",
     "turn lacks the key 'about'"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,0,0], about: "
     "[0,0,0], angles: [[0,1]]}}]",
     "the axis of a turn is zero"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [1,0,0], about: "
     "[0,0,0], angles: [[0,1,2]]}}]",
     "angles is a list of 3, but must be 1 to 1000 rows [t, angle]"},
    {"obstacles=[{plane: {point: [0,0,-1], normal: [0,0,1]}, turn: {axis: [0,2,0], about: "
     "[0.5,0,-1], angles: [[0,0],[0.5,90],[0.25,0]]}}]",
     "angles has time 0.25 after 0.5"},
    {"sheets=[{origin: [0,0,0]}]", "sheets is a list of 1, but must be a list of 2 to 8"},
    {"sheets=[{origin: [0,0,0]},{u: [1,0,0]}]", "a sheet lacks the key 'origin'"},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1],u: [2,0,0]}]",
     "sheet axis u has length 2"},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {young: 1}}]",
     "material lacks the key 'poisson'"},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {young: 1,poisson: 0.5,density: "
     "1}}]",
     "poisson is '0.5'"},
    {"sheets=[{origin: [0,0,0]},{origin: [0,0,1],material: {fabric: denim}}]",
     "sheets share their thickness, which a fabric has of its own"},
    {"supports=[{at: {sheet: 2, u: 0}, fix: x}]", "sheet is 2, but the scene has 1"},
    {"loads=[{at: {sheet: 0}, force: [1,0,0]}]", "sheet is '0', but must be"},
    {"contact.self=yes", "self is 'yes', but must be true or false"},
    {"contact.thickness=-1", "thickness is '-1'"},
    {"contact.range=0.01", "contact has a range of 0.01 m, but it must be"},
    {"contact={thickness: 0.002, range: 0.003}", "its thickness of 0.002 m"},
    {"contact.thickness=1e-300", "contact has a range of 5e-301 m"},
    {"contact.stiffness=nan", "stiffness is 'nan'"},
    {"contact.friction=-0.1", "friction is '-0.1'"},
    {"contact.rnage=1", "did you mean 'range'"},
    {"damping.alpha=2", "takes no 'alpha'"},
    {"time.end=0.01", "before the first step"},
    {"snapshots=[2]", "after the end"},
    {"discretization=3", "discretization is '3'"},
    {"discretization.points=[10,10,2,1]", "points is a list of 4"},
    {"discretization.points=[10,10,0]", "points holds '0'"},
    {"discretization.points=[10,1e1,2]", "points holds '1e1'"},
    {"discretization.points=[10,2.5,2]", "points holds '2.5'"},
    {"discretization.points=[10000,10000,10000]", "20000000 at most"},
    {"discretization.degree=[0,2,1]", "degree holds '0'"},
    {"discretization.gauss=[17,2,1]", "gauss holds '17'"},
    {"discretization.knots_u=[0,0,0.5,0.4,1,1]", "must be non-decreasing"},
    {"discretization.knots_u=[0,0,2,2]", "knots_u holds '2'"},
    {"discretization.knots_x=[0,0,1,1]", "did you mean 'knots_u'"},
    {"discretization.weights=[1,0]", "weights holds '0'"},
    {"discretization.kinematics=quantum", "one of linear, printed"},
    {"discretization.remedy=unknown", "one of none, incompatible, reduced, selective"},
    {"discretization.solver=lu", "one of auto, banded"},
    {"discretization.unknowns=[points]", "one of auto, points"},
    {"discretization.parameters=mine", "one of matched, paper"},
    {"discretization.integrator=rk4", "one of implicit, explicit"},
    {"discretization.substeps=1.5", "a whole number from 0"},
    {"discretization.iterations=-1", "a whole number from 0"},
    {"discretization.tolerance=2", "a number from 0 to 1"},
    {"discretization.bending=magic", "one of quadratic, hinge, strut"},
    {"discretization[0]=1", "discretization is a section; it has no elements"},
};

static void check_settings(void)
{
    for (size_t i = 0; i < sizeof BAD_SETTINGS / sizeof *BAD_SETTINGS; i++) {
        const char *setting = BAD_SETTINGS[i].setting;
        struct discretization d = {.points = {10, 10, 2}, .degree = {2, 2, 1}};
        struct scene scene;
        struct message why = {""};
        char beginning[256];
        enum status st;

        snprintf(beginning, sizeof beginning, "--set %s: ", setting);
        for (char *c = beginning; *c; c++)
            *c = (unsigned char)*c < ' ' ? '?' : *c;
        st = scene_file_parse("good", GOOD, strlen(GOOD), 1, &setting, &scene, &d, &why);
        check_refusal(setting, st, STATUS_INPUT, &scene, &why, beginning,
                      BAD_SETTINGS[i].part);
        CHECK(d.points[0] == 10 && d.degree[0] == 2 && !d.knots[0] && !d.weights);
        discretization_clear(&d);
    }
}

/* `head`, `count` times `item`, `tail` as a scene in memory. */
static void check_huge(const char *head, const char *item, int count, const char *tail,
                       const char *part)
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
    check_refusal(part, st, STATUS_INPUT, &scene, &why, "huge:", part);
    free(text);
    discretization_clear(&d);
}

static void check_sizes(void)
{
    check_huge("# ", "a long comment ", 80000, "", "longer than 1048576 bytes");
    check_huge("", "{", 500000, "", "");
    check_huge("obstacles: ", "[", 500000, "", "nested more than 12 deep");
    check_huge("obstacles: ", "- ", 300000, "", "");
    check_huge("obstacles: [", "{},", 300000, "]", "at most 100 obstacles");
    check_huge("gravity: [", "1,", 500000, "]", "gravity is a list of 500000");
    check_huge("obstacles: ", "x", 900000, "", "obstacles is 'xxx");
    check_huge("", "? ", 400000, "", "");
    check_huge("pose: {", "a,", 400000, "}", "second time");
}

static void check_files(void)
{
    const char *path = scratch_path("none.yaml");
    char far[1280];
    struct scene scene;
    struct message why = {""};
    enum status st;
    FILE *file;

    st = read_scene(scratch, &scene, &why);
    check_refusal("directory", st, STATUS_FILE, &scene, &why, scratch, "is a directory");
    st = read_scene(path, &scene, &why);
    check_refusal("missing", st, STATUS_FILE, &scene, &why, path, "No such file");

    path = scratch_path("pipe.yaml");
    REQUIRE(mkfifo(path, 0600) == 0); /* nobody writes: opening it would wait for ever */
    st = read_scene(path, &scene, &why);
    check_refusal("pipe", st, STATUS_FILE, &scene, &why, path, "it is a pipe");

    /* Names that would break a line or a sentence. */
    path = scratch_path("a\nb.yaml");
    file = fopen(path, "w");
    REQUIRE(file);
    fclose(file);
    st = read_scene(path, &scene, &why);
    check_refusal("line break", st, STATUS_INPUT, &scene, &why, scratch,
                  "a?b.yaml:1: empty");
    snprintf(far, sizeof far, "%s/%0900d", scratch, 0);
    st = read_scene(far, &scene, &why);
    CHECK(st == STATUS_FILE && strstr(why.text, "cannot be read as"));

    st = read_scene("/dev/zero", &scene, &why);
    check_refusal("endless", st, STATUS_INPUT, &scene, &why,
                  "/dev/zero:1: ", "longer than");
    st = read_scene("", &scene, &why);
    check_refusal("no name", st, STATUS_FILE, &scene, &why, "", "No such file");
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
