/* Readers of other people's frames: what was written in each format comes back; what is
 * wrong is refused in a sentence that says where, what, and what would be right; numbers
 * are strtod's.
 *
 *   frames FOLDER
 */
#include <hdf5.h>
#include <zip.h>

#include "bench/files/folder.h"
#include "bench/files/hdf5_file.h"
#include "bench/frames/frames.h"
#include "bench/frames/frames_bytes.h"
#include "tests/check.h"

/* A net of N_U x N_V vertices, TIMES of it, whose numbers are exact in 32 bits. */
enum { N_U = 5, N_V = 4, VERTICES = N_U * N_V, TIMES = 12 };

static void sample_uv(int n, double uv[2])
{
    uv[0] = n % N_U / (N_U - 1.);
    uv[1] = n / N_U / 4.;
}

static double sample_time(int k)
{
    return k / 16.;
}

static void sample(int k, int n, double xyz[3])
{
    double uv[2];

    sample_uv(n, uv);
    xyz[0] = uv[0] - k / 64.;
    xyz[1] = uv[1];
    xyz[2] = -k * k * (1 + uv[0]) / 128.;
}

static const char *frames_folder; /* where files go */

static FILE *create(const char *name)
{
    char path[4096];

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    FILE *file = fopen(path, "wb");
    REQUIRE(file);
    return file;
}

static void put_number(unsigned char **at, double x, int size, bool big)
{
    unsigned char byte[8];
    const float single = (float)x;

    if (size == 4)
        memcpy(byte, &single, 4);
    else
        memcpy(byte, &x, 8);
    for (int n = 0; n < size; n++)
        (*at)[n] = byte[big ? size - 1 - n : n]; /* on a little-endian machine */
    *at += size;
}

static void put_whole(unsigned char **at, unsigned long long x, int size, bool big)
{
    for (int n = 0; n < size; n++)
        (*at)[big ? size - 1 - n : n] = (unsigned char)(n < 8 ? x >> 8 * n : 0);
    *at += size;
}

enum { ROOM = 1 << 16 };

/* An array as NumPy writes it; what = x: xyz, u: uv, t: times. Its size. */
static size_t sample_array(unsigned char *room, char what, int bytes, const char *type,
                           const char *shape)
{
    unsigned char *p = room;
    char head[128];
    int used =
        snprintf(head, sizeof head,
                 "{'descr': '%s', 'fortran_order': False, 'shape': %s, }", type, shape);

    memset(head + used, ' ', sizeof head - (size_t)used);
    head[117] = '\n';
    memcpy(p, "\x93NUMPY\1\0", 8);
    p += 8;
    put_whole(&p, 118, 2, false);
    memcpy(p, head, 118);
    p += 118;
    for (int k = 0; k < (what == 'u' ? 1 : TIMES); k++)
        for (int n = 0; n < (what == 't' ? 1 : VERTICES); n++) {
            double x[3] = {sample_time(k)};
            if (what == 'x')
                sample(k, n, x);
            if (what == 'u')
                sample_uv(n, x);
            for (int c = 0; c < (what == 'x' ? 3 : what == 'u' ? 2 : 1); c++)
                put_number(&p, x[c], bytes, false);
        }
    return (size_t)(p - room);
}

static void write_npy(const char *name, const char *type, const char *shape, int bytes)
{
    unsigned char room[ROOM];
    FILE *file = create(name);
    const size_t size = sample_array(room, 'x', bytes, type, shape);

    REQUIRE(fwrite(room, 1, size, file) == size && fclose(file) == 0);
}

static void put_set(hid_t file, const char *name, int rank, const hsize_t *size,
                    const double *values)
{
    hid_t space = H5Screate_simple(rank, size, NULL);
    hid_t set = H5Dcreate2(file, name, H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT,
                           H5P_DEFAULT);

    REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Sclose(space);
}

static void write_hdf5(const char *name, hsize_t rows)
{
    char path[4096];
    double xyz[TIMES * VERTICES * 3], uv[2 * VERTICES], t[TIMES];

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    for (int k = 0; k < TIMES; k++) {
        t[k] = sample_time(k);
        for (int n = 0; n < VERTICES; n++) {
            sample(k, n, xyz + 3 * (k * VERTICES + n));
            sample_uv(n, uv + 2 * n);
        }
    }
    hdf5_file_start();
    hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(file >= 0);
    put_set(file, "xyz", 3, (hsize_t[]){TIMES, VERTICES, 3}, xyz);
    put_set(file, "uv", 2, (hsize_t[]){rows, 2}, uv);
    put_set(file, "t", 1, (hsize_t[]){TIMES}, t);
    H5Fclose(file);
}

static void write_text(const char *name, const char *text)
{
    FILE *file = create(name);

    REQUIRE(fputs(text, file) >= 0 && fclose(file) == 0);
}

/* The first so many bytes of another file. */
static void write_part(const char *name, const char *of, size_t size)
{
    char path[4096], room[ROOM];

    snprintf(path, sizeof path, "%s/%s", frames_folder, of);
    FILE *from = fopen(path, "rb"), *to = create(name);
    REQUIRE(from && fread(room, 1, size, from) == size);
    REQUIRE(fwrite(room, 1, size, to) == size && fclose(to) == 0);
    fclose(from);
}

/* --- what is written --------------------------------------------------------------------
 */

/* Rows of frames first to last, times growing or not, vertices from front or back. */
static void write_csv(const char *name, const char *header, const char *format,
                      bool shuffled)
{
    FILE *file = create(name);

    fputs(header, file);
    for (int m = 0; m < TIMES * VERTICES; m++) {
        const int mixed = m * 7 % (TIMES * VERTICES); /* 7 and 240 share no divisor */
        const int k = shuffled ? mixed % TIMES : m / VERTICES,
                  n = shuffled ? mixed / TIMES : m % VERTICES;
        double uv[2], x[3];
        sample_uv(n, uv);
        sample(k, n, x);
        fprintf(file, format, sample_time(k), uv[0], uv[1], x[0], x[1], x[2]);
    }
    REQUIRE(fclose(file) == 0);
}

static void write_obj(const char *name, int k)
{
    FILE *file = create(name);
    double x[3];

    fprintf(file, "# a mesh\no cloth\n");
    for (int n = 0; n < VERTICES; n++) {
        sample(k, n, x);
        fprintf(file, "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    }
    for (int n = VERTICES - 1; n >= 0; n--) { /* in another order than the vertices */
        sample_uv(n, x);
        fprintf(file, "vt %.9g %.9g\n", x[0], x[1]);
    }
    for (int n = 0; n < VERTICES - N_U; n++) {
        const int corner[] = {n + 1, n + 2, n + N_U + 2, n + N_U + 1};
        fputc('f', file);
        for (int c = 0; c < 4 && n % N_U < N_U - 1; c++)
            fprintf(file, " %d/%d/1", corner[c], VERTICES + 1 - corner[c]);
        fputs(n % N_U < N_U - 1 ? "\n" : " 1 2 3\n", file);
    }
    REQUIRE(fclose(file) == 0);
}

static void write_ply(const char *name, int k, const char *format)
{
    FILE *file = create(name);
    const bool ascii = !strcmp(format, "ascii"), big = strstr(format, "big") != NULL;

    fprintf(
        file,
        "ply\nformat %s 1.0\ncomment c\nelement vertex %d\nproperty double x\nproperty "
        "float y\nproperty float z\nproperty float s\nproperty float t\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n",
        format, VERTICES);
    for (int n = 0; n < VERTICES; n++) {
        unsigned char row[64], *p = row;
        double x[3], uv[2];
        sample(k, n, x);
        sample_uv(n, uv);
        if (ascii)
            fprintf(file, "%.17g %.17g %.17g %.17g %.17g\n", x[0], x[1], x[2], uv[0],
                    uv[1]);
        put_number(&p, x[0], 8, big);
        put_number(&p, x[1], 4, big);
        put_number(&p, x[2], 4, big);
        put_number(&p, uv[0], 4, big);
        put_number(&p, uv[1], 4, big);
        if (!ascii)
            fwrite(row, 1, (size_t)(p - row), file);
    }
    unsigned char face[16], *p = face;
    put_whole(&p, 3, 1, big);
    for (int n = 0; n < 3; n++)
        put_whole(&p, (unsigned)n, 4, big);
    if (ascii)
        fputs("3 0 1 2\n", file);
    else
        fwrite(face, 1, (size_t)(p - face), file);
    REQUIRE(fclose(file) == 0);
}

static void add(zip_t *z, const char *name, unsigned char *room, size_t size, bool deflated)
{
    const zip_int64_t n =
        zip_file_add(z, name, zip_source_buffer(z, room, size, 0), ZIP_FL_OVERWRITE);

    REQUIRE(n >= 0 && !zip_set_file_compression(
                          z, (zip_uint64_t)n, deflated ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 0));
}

static void write_npz(const char *name, int bytes, bool deflated, const char *shape)
{
    unsigned char uv[ROOM], xyz[ROOM], t[ROOM];
    const char *type = bytes == 4 ? "<f4" : "<f8";
    char path[4096];

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    zip_t *z = zip_open(path, ZIP_CREATE | ZIP_TRUNCATE, NULL);
    REQUIRE(z);
    add(z, "uv.npy", uv, sample_array(uv, 'u', bytes, type, "(20, 2)"), deflated);
    add(z, "xyz.npy", xyz, sample_array(xyz, 'x', bytes, type, shape), deflated);
    add(z, "t.npy", t, sample_array(t, 't', 8, "<f8", "(12,)"), false);
    REQUIRE(zip_close(z) == 0);
}

static void write_cache(const char *name, bool mdd)
{
    unsigned char room[ROOM], *p = room;
    FILE *file = create(name);

    if (mdd) {
        put_whole(&p, TIMES, 4, true);
        put_whole(&p, VERTICES, 4, true);
        for (int k = 0; k < TIMES; k++)
            put_number(&p, sample_time(k), 4, true);
    } else {
        memcpy(p, "POINTCACHE2\0\1\0\0\0", 16);
        p += 16;
        put_whole(&p, VERTICES, 4, false);
        put_number(&p, 0, 4, false);
        put_number(&p, 1, 4, false);
        put_whole(&p, TIMES, 4, false);
    }
    for (int k = 0; k < TIMES; k++)
        for (int n = 0; n < VERTICES; n++) {
            double x[3];
            sample(k, n, x);
            for (int c = 0; c < 3; c++)
                put_number(&p, x[c], 4, mdd);
        }
    REQUIRE(fwrite(room, 1, (size_t)(p - room), file) == (size_t)(p - room));
    REQUIRE(fclose(file) == 0);
}

/* --- what comes back ---------------------------------------------------------------------
 */

/* Frames are told by their uv, so that their order is theirs; without uv it is ours. */
static void check_back(const char *name, double dt, const char *rest, bool has_uv)
{
    char path[4096], mesh[4096];
    const char *paths[] = {path};
    struct frames *f = NULL;
    struct message why = {""};
    const double *xyz;
    double t;
    int frames = 0;

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    snprintf(mesh, sizeof mesh, "%s/%s", frames_folder, rest ? rest : "");
    if (!CHECK(frames_open(1, paths, &(struct frames_look){dt, rest ? mesh : NULL}, &f,
                           &why) == STATUS_OK)) {
        printf("%s: %s\n", name, why.text);
        return;
    }
    const struct frames_net *net = frames_net(f);
    CHECK((net->uv != NULL) == has_uv && net->vertices == VERTICES);
    for (;; frames++) {
        if (!CHECK(frames_next(f, &t, &xyz, &why) == STATUS_OK) || !xyz)
            break;
        const double step = dt > 0 ? dt : 1 / 16.;
        bool good = t == frames * step;
        for (int n = 0; n < VERTICES; n++) {
            double want[3];
            const int m =
                has_uv ? (int)(4 * net->uv[2 * n] + N_U * 4 * net->uv[2 * n + 1] + .5) : n;
            sample(frames, m, want);
            good = good && !memcmp(want, xyz + 3 * n, sizeof want);
        }
        if (!CHECK(good))
            printf("%s: frame %d differs\n", name, frames + 1);
    }
    CHECK(frames == TIMES);
    if (*why.text || frames != TIMES)
        printf("%s: %d frames, %s\n", name, frames, why.text);
    frames_close(f);
}

static void round_trips(void)
{
    char name[64];

    write_csv("plain.csv", "", "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", false);
    check_back("plain.csv", 0, NULL, true);
    write_csv("spaced.csv", "# made\n\nt, u, v, x, y, z\r\n",
              "%.18e, %.18e, %.18e, %.18e, %.18e, %.18e\r\n", true);
    check_back("spaced.csv", 0, NULL, true);
    write_csv("columns.csv", "vertex,t,u,v,w,x,y,z,more\n",
              "name,%g,%.17g,%.17g,.5,%.17g,%.17g,%.17g,more\n", true);
    check_back("columns.csv", 0, NULL, true);
    folder_make((snprintf(name, sizeof name, "%s/objs", frames_folder), name), NULL);
    for (int k = 0; k < TIMES; k++) {
        snprintf(name, sizeof name, "objs/s%d.obj", k + 1); /* s1, s10, s11, s12, s2 */
        write_obj(name, k);
    }
    write_text("objs/notes.txt", "not a frame\n");
    check_back("objs", 0.25, NULL, true);
    static const char *const formats[] = {"ascii", "binary_little_endian",
                                          "binary_big_endian"};
    for (int n = 0; n < 3; n++) {
        char path[128];
        snprintf(path, sizeof path, "%s/%s", frames_folder, formats[n]);
        folder_make(path, NULL);
        for (int k = 0; k < TIMES; k++) {
            snprintf(path, sizeof path, "%s/f%03d.ply", formats[n], k);
            write_ply(path, k, formats[n]);
        }
        check_back(formats[n], 0.5, NULL, true);
    }
    for (int n = 0; n < 4; n++) {
        snprintf(name, sizeof name, "n%d.npz", n);
        write_npz(name, n & 1 ? 8 : 4, n & 2, n & 2 ? "(12, 4, 5, 3)" : "(12, 20, 3)");
        check_back(name, 0, NULL, true);
        check_back(name, 0.125, NULL, true);
    }
    write_npy("bare.npy", "<f8", "(12, 20, 3)", 8);
    check_back("bare.npy", 0.5, NULL, false);
    check_back("bare.npy", 0.5, "objs/s1.obj", true);
    write_cache("c.mdd", true);
    check_back("c.mdd", 0, "objs/s1.obj", true);
    write_cache("c.pc2", false);
    check_back("c.pc2", 0.125, "objs/s1.obj", true);
    write_hdf5("c.h5", VERTICES);
    check_back("c.h5", 0, NULL, true);
}

/* --- what is refused ---------------------------------------------------------------------
 */

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

/* --- small things ------------------------------------------------------------------------
 */

/* To the bit as strtod has it. */
static void check_number(const char *text)
{
    const char *p = text;
    char *stop;
    const double want = strtod(text, &stop);
    double got = NAN;

    if (!CHECK(frames_text_number(&p, text + strlen(text), &got) && p == stop) ||
        !CHECK(!memcmp(&got, &want, sizeof got)))
        printf("  %s: %.17g, not %.17g\n", text, got, want);
}

static void numbers(void)
{
    static const char *const text[] = {"0",
                                       "-0.5",
                                       "1e-3",
                                       "+2.5E+4",
                                       ".5",
                                       "5.",
                                       "123456789012345678901234567890",
                                       "0.1",
                                       "-9.81000000000000049960e-02",
                                       "1e-310",
                                       "1e400",
                                       "0x1p-3",
                                       "1e",
                                       "3.14,2",
                                       "0.00000000000000000000000000000123",
                                       "179769313486231570000e288",
                                       "9007199254740993"};

    for (size_t n = 0; n < sizeof text / sizeof *text; n++)
        check_number(text[n]);
    const char *none = "x1", *p = none;
    double x;
    CHECK(!frames_text_number(&p, none + 2, &x));
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    frames_folder = argv[1];
    REQUIRE(folder_make(frames_folder, &why) == STATUS_OK);
    numbers();
    round_trips();
    bad_texts();
    bad_sequences();
    bad_binaries();
    return check_result();
}
