/* Readers of other people's frames: the samples come back in each format (tests/samples,
 * see its README); what is wrong is refused in a sentence that says where.
 */
#include "bench/frames/frames.h"

#include <sys/stat.h>

#include "tests/scratch.h"

#define SAMPLES SOURCE_DIR "/tests/samples/"

/* A net of N_U x N_V vertices, TIMES of it, whose numbers are exact in 32 bits. */
enum { N_U = 5, N_V = 4, VERTICES = N_U * N_V, TIMES = 3 };

static void sample(int k, int n, double xyz[3])
{
    const double u = n % N_U / (N_U - 1.), v = n / N_U / 4.;

    xyz[0] = u - k / 64., xyz[1] = v, xyz[2] = -k * k * (1 + u) / 128.;
}

/* Reads all frames; *same: how many are the sample's, at their times. Vertices are told by
 * their uv, so that their order is the file's; without uv it is ours. */
static enum status read_all(const char *path, double dt, const char *rest, bool has_uv,
                            int *same, struct message *why)
{
    struct frames *f = NULL;
    const double *xyz = NULL;
    double t;
    enum status st = frames_open(1, &path, &(struct frames_look){dt, rest}, &f, why);

    *same = 0;
    for (int k = 0; st == STATUS_OK; k++) {
        const struct frames_net *net = frames_net(f);
        st = frames_next(f, &t, &xyz, why);
        if (st != STATUS_OK || !xyz)
            break;
        bool good = (net->uv != NULL) == has_uv && net->vertices == VERTICES &&
                    t == k * (dt > 0 ? dt : 1 / 16.);
        for (int n = 0; n < VERTICES && good; n++) {
            const double *uv = net->uv + 2 * n;
            double want[3];
            sample(k, has_uv ? (int)(4 * uv[0] + N_U * 4 * uv[1] + .5) : n, want);
            good = !memcmp(want, xyz + 3 * n, sizeof want);
        }
        *same = good && *same == k ? k + 1 : -1;
    }
    frames_close(f);
    return st;
}

/* Returns how many triangles a file's net has, if the first two are those of the cell 0. */
static int triangles_of(const char *path)
{
    static const int first[2][3] = {{0, 1, 6}, {0, 6, 5}};
    struct frames *f = NULL;
    int count = 0;

    if (frames_open(1, &path, &(struct frames_look){0}, &f, NULL) == STATUS_OK &&
        !memcmp(frames_net(f)->triangle, first, sizeof first))
        count = frames_net(f)->triangles;
    frames_close(f);
    return count;
}

static void come_back(void)
{
    static const struct {
        const char *path, *rest;
        double dt;
        bool without_uv;
        int triangles; /* of the file, beside those of a mesh */
    } row[] = {{SAMPLES "plain.csv"},
               {SAMPLES "spaced.csv"},
               {SAMPLES "columns.csv"},
               {SAMPLES "objs", .dt = 0.25},
               {SAMPLES "ply", .dt = 0.5},
               {SAMPLES "stored.npz"},
               {SAMPLES "packed.npz"},
               {SAMPLES "packed.npz", .dt = 0.125},
               {SAMPLES "bare.npy", .dt = 0.5, .without_uv = true},
               {SAMPLES "bare.npy", SAMPLES "objs/s9.obj", .dt = 0.5},
               {SAMPLES "c.mdd", SAMPLES "objs/s9.obj"},
               {SAMPLES "c.pc2", SAMPLES "objs/s9.obj", .dt = 0.125},
               {SAMPLES "c.h5"},
               {SAMPLES "faces.npz", .triangles = 24},
               {SAMPLES "faces.h5", .triangles = 24},
               {SAMPLES "semicolons.csv"},
               {SAMPLES "rate.pc2", SAMPLES "objs/s9.obj"},
               {SAMPLES "rate.pc2", SAMPLES "objs/s9.obj", .dt = 0.125}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        struct message why = {""};
        int same;
        if (!CHECK(read_all(row[n].path, row[n].dt, row[n].rest, !row[n].without_uv, &same,
                            &why) == STATUS_OK &&
                   same == TIMES &&
                   (!row[n].triangles || triangles_of(row[n].path) == row[n].triangles)))
            printf("%s: %d frames, %s\n", row[n].path, same, why.text);
    }
}

/* --- what is refused --- */

static void write_text(const char *name, const char *text)
{
    FILE *file = fopen(name, "wb");

    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
}

/* Its sentence begins with the path and says where. */
static void check_refused(const char *path, double dt, const char *where)
{
    struct message why = {""};
    int same;
    const enum status st = read_all(path, dt, NULL, true, &same, &why);

    if (!CHECK((st == STATUS_INPUT || st == STATUS_FILE) && strstr(why.text, where) &&
               !strncmp(why.text, path, strlen(path))))
        printf("%s: %d, \"%s\" has not \"%s\"\n", path, (int)st, why.text, where);
}

/* A file with this text, and what its refusal has. */
struct bad_text {
    const char *name, *text, *where;
};

static void check_texts(size_t count, const struct bad_text *row)
{
    for (size_t n = 0; n < count; n++) {
        write_text(row[n].name, row[n].text);
        check_refused(row[n].name, strstr(row[n].name, ".csv") ? 0 : 1, row[n].where);
    }
}

static void bad_texts(void)
{
    static const struct bad_text row[] = {
        {"empty.csv", "", "empty.csv"},
        {"words.csv", "t,u,v,x,y,z\n0,0,0,0,0,0\n0,1,0,one,0,0\n", "line 3"},
        {"short.csv", "0,0,0,0,0,0\n0,1,0,1,0\n", "line 2"},
        {"comma.csv", "t,u,v,x,y,z\n0,0,0,0,0,0,5\n", "line 2: has 7 cells in 6 columns"},
        {"uv.csv", "t,x,y,z\n0,0,0,0\n", "line 1"},
        {"bare.csv", "t,u,v,x,y,z\n", "bare.csv"},
        {"nan.csv", "0,0,0,0,0,0\n0,1,0,nan,0,0\n", "frame 1 (t = 0 s)"},
        {"inf.csv", "0,0,0,0,0,0\n1,0,0,0,0,-inf\n", "frame 2 (t = 1 s)"},
        {"far.csv", "0,0,0,0,0,0\n1,0,0,0,1e200,0\n",
         "has y = 1e+200; a number below 1e+100"},
        {"v.csv", "0,0,0,0,0,0\n0,0,nan,0,0,0\n", "v.csv: v of vertex 2"},
        {"t.csv", "0,0,0,0,0,0\nnan,0,0,0,0,0\n", "line 2"},
        {"more.csv", "0,0,0,0,0,0\n1,0,0,0,0,0\n1,1,0,0,0,0\n",
         "line 3: frame 2 (t = 1 s)"},
        {"less.csv", "0,0,0,0,0,0\n0,1,0,0,0,0\n1,0,0,0,0,0\n", "frame 2 (t = 1 s)"},
        {"twice.csv", "0,0,0,0,0,0\n0,1,0,0,0,0\n1,0,0,0,0,0\n1,0,0,0,0,0\n",
         "line 4: frame 2"},
        {"no.npz", "not a zip file, but long enough", "no.npz"},
        {"no.npy", "not an array", "no.npy"},
        {"no.mdd", "abcdefghij", "no.mdd"},
        {"short.pc2", "POINTCACHE2", "short.pc2"},
        {"no.h5", "not sealed, and no HDF5 of others", "no.h5"},
        {"no.txt", "frames", "no.txt"},
    };

    check_texts(sizeof row / sizeof *row, row);
}

static void bad_meshes(void)
{
#define HEAD   "ply\nformat ascii 1.0\n"
#define XYZ    "property float x\nproperty float y\nproperty float z\n"
#define VERTEX "element vertex 1\n" XYZ
#define FACE   "element face 1\nproperty list uchar int vertex_indices\n"
    static const struct bad_text row[] = {
        {"none.obj", "# nothing\n", "none.obj"},
        {"v.obj", "v 1 2\n", "v.obj:1:"},
        {"f.obj", "v 0 0 0\nf 1 1 2\n", "f.obj:2:"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line.obj:3:"},
        {"seam.obj",
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf -3/2 -2 -1\n",
         "seam.obj:7:"},
        {"no.ply", "plz\n", "line 1"},
        {"end.ply", HEAD "element vertex 1\n" XYZ, "end.ply"},
        {"huge.ply", HEAD "element vertex 4000000000\n" XYZ "end_header\n", "line 3"},
        {"lone.ply", HEAD "property float x\n", "line 3"},
        {"type.ply", HEAD "element vertex 1\nproperty quad x\n", "line 4"},
        {"xy.ply", HEAD "element vertex 1\nproperty float x\nend_header\n0\n", "line 5"},
        {"few.ply", HEAD "element vertex 2\n" XYZ "end_header\n0 0 0\n0 0\n", "few.ply"},
        {"far.ply", HEAD VERTEX FACE "end_header\n0 0 0\n3 0 0 1\n", "far.ply"},
        {"list.ply", HEAD "element vertex 1\nproperty list float int vertex_indices\n",
         "line 4"},
        {"two.ply", HEAD VERTEX FACE "end_header\n0 0 0\n2 0 0\n", "line 11"},
        {"open.ply", HEAD VERTEX FACE "end_header\n0 0 0\n3 0 0\n", "open.ply"},
        {"vt.obj", "v 0 0 0\nvt 0 0\nf 1/1 1/2 1/1\n", "vt.obj:3:"},
    };

    check_texts(sizeof row / sizeof *row, row);
}

static void bad_sequences(void)
{
#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define FACES  "f 1 2 3\nf 1 3 4\n"
    static const struct {
        const char *name, *file, *text, *where;
    } row[] = {
        {"remeshed", "remeshed/a2.obj", SQUARE "f 1 2 4\nf 2 3 4\n", "a2.obj: frame 2"},
        {"grown", "grown/a2.obj", SQUARE "v 2 2 2\n" FACES, "a2.obj: frame 2"},
        {"mixed", "mixed/a2.ply", "ply\n", "a2.ply"},
        {"missing", "missing/a2.obj", SQUARE FACES, "a4.obj: comes after number 2"}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        char first[64];
        snprintf(first, sizeof first, "%s/a1.obj", row[n].name);
        REQUIRE(mkdir(row[n].name, 0777) == 0);
        write_text(first, SQUARE FACES);
        if (!strcmp(row[n].name, "missing"))
            write_text("missing/a4.obj", SQUARE FACES);
        write_text(row[n].file, row[n].text);
        check_refused(row[n].name, 1, row[n].where);
    }
    REQUIRE(mkdir("two", 0777) == 0 && mkdir("nothing", 0777) == 0);
    write_text("two/a.csv", "0,0,0,0,0,0\n");
    write_text("two/b.csv", "1,0,0,0,0,0\n");
    check_refused("two", 1, "two/a.csv");
    check_refused("nothing", 1, "nothing");
    check_refused("absent", 1, "absent");
    check_refused(SAMPLES "objs", 0, "objs");
    check_refused(SAMPLES "bare.npy", 0, "bare.npy");
    check_refused(SAMPLES "c.pc2", 0, "c.pc2");
}

/* A sample with other bytes in the last place that has some, or cut. */
static void write_changed(const char *name, const char *of, size_t size, const char *was,
                          const char *is, size_t length)
{
    char path[512], bytes[1 << 14];

    snprintf(path, sizeof path, SAMPLES "%s", of);
    FILE *from = fopen(path, "rb"), *to = fopen(name, "wb");
    REQUIRE(from && to);
    const size_t all = fread(bytes, 1, sizeof bytes, from), n = size ? size : all;
    char *at = bytes;

    for (size_t k = 0; was && k + strlen(was) <= all; k++)
        at = memcmp(bytes + k, was, strlen(was)) == 0 ? bytes + k : at;
    REQUIRE((at > bytes || !was) && n <= all && at + length <= bytes + all);
    memcpy(at, is, length);
    REQUIRE(fwrite(bytes, 1, n, to) == n && fclose(to) == 0 && fclose(from) == 0);
}

static void bad_binaries(void)
{
#define SHAPE "(3, 20, 3), }" /* blanks follow, to fill the header */
    static const struct {
        const char *name, *of, *where;
        size_t size; /* 0: all */
        const char *was, *is;
        double dt;
    } row[] = {{"long.npy", "bare.npy", "long.npy", 0, SHAPE, "(4, 20, 3), }", 1},
               {"vast.npy", "bare.npy", "", 0, SHAPE, "(4000000, 4000000, 3), }", 1},
               {"wide.npy", "bare.npy", "", 0, SHAPE, "(3, 15, 4), }", 1},
               {"flat.npy", "bare.npy", "", 0, SHAPE, "(180,), }    ", 1},
               {"none.npy", "bare.npy", "", 0, SHAPE, "(0, 20, 3), }", 1},
               {"deep.npy", "bare.npy", "", 0, SHAPE, "(1, 1, 1, 1, 1, 1), }", 1},
               {"long double.npy", "bare.npy", "", 0, "<f8", "<f1", 1},
               {"complex.npy", "bare.npy", "", 0, "<f8", "<c8", 1},
               {"cut.npy", "bare.npy", "", 1000, NULL, "", 1},
               {"turned.npz", "stored.npz", "uv", 0, "(20, 2), }", "(2, 20), }", 0},
               {"cut.npz", "stored.npz", "", 1200, NULL, "", 0},
               {"cut.mdd", "c.mdd", "", 500, NULL, "", 1},
               {"cut.h5", "c.h5", "", 1000, NULL, "", 0}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        write_changed(row[n].name, row[n].of, row[n].size, row[n].was, row[n].is,
                      strlen(row[n].is));
        check_refused(row[n].name, row[n].dt, row[n].where);
    }
    /* sizes that the directory of a ZIP file announces, and xyz has not: its row there has
     * checksum, packed size and size */
#define IN_DIRECTORY "\x6a\xbc\x55\x1a\x1d\1"
    write_changed("lie.npz", "packed.npz", 0, IN_DIRECTORY,
                  IN_DIRECTORY "\0\0\xff\xff\xff\x7f", 12);
    check_refused("lie.npz", 0, "lie.npz: xyz.npy");
    write_changed("less.npz", "packed.npz", 0, IN_DIRECTORY, IN_DIRECTORY "\0\0\xd0\5\0",
                  12);
    check_refused("less.npz", 0, "less.npz: xyz");
    write_changed("zero.csv", "plain.csv", 0, "\n", "\0", 1); /* the last line's end */
    check_refused("zero.csv", 0, "zero.csv: line");
    check_refused(SAMPLES "far_faces.npz", 0,
                  "far_faces.npz: faces: face 3 has a vertex 20");
    check_refused(SAMPLES "rows.h5", 0, "rows.h5: uv");
    check_refused(SAMPLES "huge.h5", 0, "huge.h5");
}

int main(void)
{
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    come_back();
    bad_texts();
    bad_meshes();
    bad_sequences();
    bad_binaries();
    return check_result();
}
