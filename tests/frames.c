/* Readers of other people's frames: what was written in each format comes back; what is
 * wrong is refused in a sentence that says where, what, and what would be right; numbers
 * are strtod's.
 *
 *   frames FOLDER
 */
#include <zip.h>

#include "bench/files/folder.h"
#include "bench/frames/frames_bytes.h"
#include "tests/frames_fixture.h"

const char *frames_folder;

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
    const int bad = frames_bad();
    return check_result() || bad;
}
