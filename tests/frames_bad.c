/* Frames that are refused, each in a sentence that says where, what, and what would be
 * right. Some are cut from the sound files of frames.c. */
#include "bench/files/folder.h"
#include "tests/frames_fixture.h"

/* Its sentence begins with the folder and has both parts. */
static void check_refused(const char *name, double dt, const char *where, const char *what)
{
    char path[4096];
    const char *paths[] = {path};
    struct frames *f = NULL;
    struct message why = {""};
    const double *xyz = NULL;
    double t;

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    enum status st = frames_open(1, paths, &(struct frames_look){dt, NULL}, &f, &why);
    if (st == STATUS_OK)
        do
            st = frames_next(f, &t, &xyz, &why);
        while (st == STATUS_OK && xyz);
    if (!CHECK((st == STATUS_INPUT || st == STATUS_FILE) && strstr(why.text, where) &&
               strstr(why.text, what) &&
               !strncmp(why.text, frames_folder, strlen(frames_folder))))
        printf("%s: %d, \"%s\" has not \"%s\" and \"%s\"\n", name, (int)st, why.text, where,
               what);
    frames_close(f);
}

static void bad_texts(void)
{
#define HEAD "ply\nformat ascii 1.0\n"
#define XYZ  "property float x\nproperty float y\nproperty float z\n"
    static const struct {
        const char *name, *text, *where, *what;
    } row[] = {
        {"empty.csv", "", "empty.csv", "is empty"},
        {"words.csv", "t,u,v,x,y,z\n0,0,0,0,0,0\n0,1,0,one,0,0\n", "line 3",
         "row of numbers"},
        {"short.csv", "0,0,0,0,0,0\n0,1,0,1,0\n", "line 2", "row of numbers"},
        {"uv.csv", "t,x,y,z\n0,0,0,0\n", "line 1", "no column u"},
        {"bare.csv", "t,u,v,x,y,z\n", "bare.csv", "no rows"},
        {"nan.csv", "0,0,0,0,0,0\n0,1,0,nan,0,0\n", "frame 1 (t = 0 s)",
         "vertex 2 has x = nan"},
        {"inf.csv", "0,0,0,0,0,0\n1,0,0,0,0,-inf\n", "frame 2 (t = 1 s)", "z = -inf"},
        {"t.csv", "0,0,0,0,0,0\nnan,0,0,0,0,0\n", "line 2", "row of numbers"},
        {"more.csv", "0,0,0,0,0,0\n1,0,0,0,0,0\n1,1,0,0,0,0\n", "line 3: frame 2 (t = 1 s)",
         "u = 1, v = 0 that the first frame has not"},
        {"less.csv", "0,0,0,0,0,0\n0,1,0,0,0,0\n1,0,0,0,0,0\n", "frame 2 (t = 1 s)",
         "has 1 vertices, the first frame 2"},
        {"twice.csv", "0,0,0,0,0,0\n0,1,0,0,0,0\n1,0,0,0,0,0\n1,0,0,0,0,0\n",
         "line 4: frame 2", "twice"},
        {"none.obj", "# nothing\n", "none.obj", "has no vertices"},
        {"v.obj", "v 1 2\n", "line 1", "no vertex"},
        {"f.obj", "v 0 0 0\nf 1 2 3\n", "line 2", "not there"},
        {"line.obj", "v 0 0 0\nv 1 0 0\nf 1 2\n", "line 3", "fewer than three"},
        {"seam.obj",
         "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 2 3\n", "line 7",
         "second vt"},
        {"no.ply", "plz\n", "line 1", "`ply`"},
        {"end.ply", HEAD "element vertex 1\n" XYZ, "end.ply", "before end_header"},
        {"huge.ply", HEAD "element vertex 4000000000\n" XYZ "end_header\n", "line 3",
         "more than the file can hold"},
        {"lone.ply", HEAD "property float x\n", "line 3", "of no element"},
        {"type.ply", HEAD "element vertex 1\nproperty quad x\n", "line 4", "type"},
        {"xy.ply", HEAD "element vertex 1\nproperty float x\nend_header\n0\n", "line 5",
         "x, y and z"},
        {"few.ply", HEAD "element vertex 2\n" XYZ "end_header\n0 0 0\n0 0\n", "few.ply",
         "fewer than its header counts"},
        {"far.ply",
         HEAD "element vertex 1\n" XYZ "element face 1\nproperty list uchar int "
              "vertex_indices\nend_header\n0 0 0\n3 0 1 2\n",
         "far.ply", "not there"},
        {"no.npz", "not a zip file, but long enough", "no.npz", "no ZIP file"},
        {"no.npy", "not an array", "no.npy", "no array of NumPy"},
        {"no.mdd", "abcdefghij", "no.mdd", "as many as it counts"},
        {"short.pc2", "POINTCACHE2", "short.pc2", "counts"},
        {"no.h5", "not sealed, and no HDF5 of others", "no.h5", ""},
        {"no.txt", "frames", "no.txt", "of no kind that is read"},
    };

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        write_text(row[n].name, row[n].text);
        check_refused(row[n].name, strstr(row[n].name, ".csv") ? 0 : 1, row[n].where,
                      row[n].what);
    }
}

static void bad_sequences(void)
{
    char path[4096];

    for (int n = 0; n < 4; n++) {
        static const char *const names[] = {"nothing", "remeshed", "mixed", "grown"};
        snprintf(path, sizeof path, "%s/%s", frames_folder, names[n]);
        REQUIRE(folder_make(path, NULL) == STATUS_OK);
    }
    check_refused("nothing", 1, "nothing", "has no frames in it");
    check_refused("absent", 1, "absent", "");
    static const char square[] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    char text[256];
    snprintf(text, sizeof text, "%sf 1 2 3\nf 1 3 4\n", square);
    write_text("remeshed/a1.obj", text);
    write_text("grown/a1.obj", text);
    write_text("mixed/a1.obj", text);
    snprintf(text, sizeof text, "%sf 1 2 4\nf 2 3 4\n", square);
    write_text("remeshed/a2.obj", text);
    check_refused("remeshed", 1, "a2.obj: frame 2", "other faces");
    snprintf(text, sizeof text, "%sv 2 2 2\nf 1 2 3\nf 1 3 4\n", square);
    write_text("grown/a37.obj", text);
    check_refused("grown", 1, "a37.obj: frame 2", "has 5 vertices, the first frame 4");
    write_text("mixed/a2.ply", "ply\n");
    check_refused("mixed", 1, "a2.ply", "another kind");
    check_refused("objs", 0, "objs", "--dt");
}

/* A ZIP file with another size of its second member in its directory. */
static void write_lie(const char *name, const char *of, unsigned long long size)
{
    char path[4096];
    unsigned char room[ROOM], *p = room;

    snprintf(path, sizeof path, "%s/%s", frames_folder, of);
    FILE *from = fopen(path, "rb"), *to = create(name);
    REQUIRE(from);
    const size_t length = fread(room, 1, sizeof room, from);
    for (int members = 0; p < room + length - 4; p++)
        if (!memcmp(p, "PK\1\2", 4) && ++members == 2)
            break;
    REQUIRE(p < room + length - 4);
    p += 24;
    put_whole(&p, size, 4, false);
    REQUIRE(fwrite(room, 1, length, to) == length && fclose(to) == 0);
    fclose(from);
}

static void bad_binaries(void)
{
    static const struct {
        const char *name, *type, *shape, *what;
    } array[] = {{"long.npy", "<f8", "(13, 20, 3)", "cut off"},
                 {"vast.npy", "<f8", "(4000000, 4000000, 3)", "cut off"},
                 {"wide.npy", "<f8", "(12, 15, 4)", "[frames][n][3]"},
                 {"flat.npy", "<f8", "(720,)", "[frames][n][3]"},
                 {"none.npy", "<f8", "(0, 20, 3)", "has no frames"},
                 {"big.npy", ">f8", "(12, 20, 3)", "little-endian"},
                 {"whole.npy", "<i8", "(12, 20, 3)", "little-endian"},
                 {"deep.npy", "<f8", "(1, 1, 1, 1, 1, 1)", "little-endian"}};

    for (size_t n = 0; n < sizeof array / sizeof *array; n++) {
        write_npy(array[n].name, array[n].type, array[n].shape, 8);
        check_refused(array[n].name, 1, array[n].name, array[n].what);
    }
    write_part("cut.npz", "n0.npz", 2000);
    check_refused("cut.npz", 0, "cut.npz", "is cut off or no ZIP file");
    /* sizes that the directory announces and the member has not: of xyz, in the middle */
    write_lie("lie.npz", "n2.npz", 0x7fffffff);
    check_refused("lie.npz", 0, "lie.npz: xyz.npy", "impossible size");
    write_lie("less.npz", "n2.npz", 2000);
    check_refused("less.npz", 0, "less.npz: xyz", "cut off");
    write_part("cut.npy", "bare.npy", 2000);
    check_refused("cut.npy", 1, "cut.npy", "cut off");
    write_part("cut.mdd", "c.mdd", 1000);
    check_refused("cut.mdd", 1, "cut.mdd", "counts 12 frames of 20 points");
    write_part("cut.h5", "c.h5", 1000);
    check_refused("cut.h5", 0, "cut.h5", "");
    write_hdf5("rows.h5", VERTICES - 1);
    check_refused("rows.h5", 0, "rows.h5: uv", "has 38 numbers; 40");
}

int frames_bad(void)
{
    bad_texts();
    bad_sequences();
    bad_binaries();
    return check_result();
}
