/* Result files that were damaged on the way - bits, bytes, pieces lost or put in - are told
 * in a sentence: 2,000 stored truths and 2,000 runs, with a fixed seed. None is believed,
 * none crashes what reads it.
 */

#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/harness/contestant.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth.h"
#include "models/reader/scene_file.h"
#include "tests/scratch.h"
#include "tests/text.h"

enum { DAMAGES = 2000 };

static unsigned long seed = 20260101;

/* 0 <= number < limit (Knuth's MMIX generator). */
static long draw(long limit)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (long)((seed >> 33) % (unsigned long)limit);
}

static unsigned char *read_all(const char *path, long *size)
{
    FILE *file = fopen(path, "rb");
    unsigned char *bytes;

    REQUIRE(file && fseek(file, 0, SEEK_END) == 0);
    *size = ftell(file);
    rewind(file);
    bytes = malloc((size_t)*size + 16);
    REQUIRE(bytes && fread(bytes, 1, (size_t)*size, file) == (size_t)*size);
    fclose(file);
    return bytes;
}

/* Damages bytes[size], whose room is larger by 16; returns the new size. Every other time
 * in the first kilobytes, where the structure is. */
static long damage(unsigned char *bytes, long size)
{
    const long at = draw(2) ? draw(size) : draw(size < 8192 ? size : 8192);

    switch (draw(4)) {
    case 0:
        bytes[at] ^= (unsigned char)(1 << draw(8));
        return size;
    case 1:
        for (long n = at; n < at + 8 && n < size; n++)
            bytes[n] = (unsigned char)~bytes[n];
        return size;
    case 2:
        return at;
    default:
        memmove(bytes + at + 16, bytes + at, (size_t)(size - at));
        memset(bytes + at, 0x5a, 16);
        return size + 16;
    }
}

/* Damages it time and again; `read` says what it makes of the file. */
static void try_all(const char *good, const char *bad,
                    enum status (*read)(const char *path, struct message *why))
{
    struct message why;
    int refused = 0, told = 0;
    long size;
    unsigned char *bytes = read_all(good, &size), *copy = malloc((size_t)size + 16);

    REQUIRE(copy);
    CHECK(read(good, &why) == STATUS_OK);
    for (int n = 0; n < DAMAGES; n++) {
        memcpy(copy, bytes, (size_t)size);
        text_put(bad, copy, (size_t)damage(copy, size));
        why.text[0] = '\0';
        const enum status st = read(bad, &why);
        refused += st == STATUS_INPUT;
        told += strstr(why.text, bad) && !strchr(why.text, '\n');
    }
    CHECK(refused == DAMAGES);
    CHECK(told == DAMAGES);
    free(bytes);
    free(copy);
}

static enum status read_truth(const char *path, struct message *why)
{
    struct truth made;
    const enum status st = truth_file_read(path, &made, why);

    if (st == STATUS_OK)
        truth_clear(&made);
    return st;
}

static enum status read_run(const char *path, struct message *why)
{
    struct run_result r = {0};
    const enum status st = run_result_read(path, true, &r, why);

    run_result_clear(&r);
    return st;
}

static void make_run(const char *path, const char *model, const char *name)
{
    struct case_plan plan = {.end = 0.02, .keep = {.file = path, .every = 1}};
    char *scene = NULL;

    REQUIRE(contestant_find(model, &plan.contestant, NULL) == STATUS_OK);
    REQUIRE(scene_file_find(name, &scene, NULL) == STATUS_OK);
    plan.path = scene;
    REQUIRE(run_file_write(&plan, NULL, NULL) == STATUS_OK);
    free(scene);
}

/* --- Files that somebody made on purpose, sealed as ours: a text that is many, a number
 * that is many, arrays far larger than their file, of another type, rank or shape; and of
 * a garment, whose pattern is read from arrays. */
static const struct made {
    const char *name, *part; /* attribute if there is none such; in the sentence        */
    int rank;                /* 0: it is removed                                        */
    hsize_t size[5];
    char kind;  /* 'a': numbers of an attribute, 't': texts of one, 'c': texts, 'n': NaN
                   in its shape, 'm': in the attribute                                  */
    bool zeros; /* written, else the array is not there                                 */
} made[] = {
    {"outcome", ": has no text outcome", 1, {4000}, 't', true},
    {"unknowns", ": has no number unknowns", 1, {4000}, 'a', true},
    {"time", ": time: is no array", 2, {1ul << 32, 1ul << 32}}, /* product 0           */
    {"time", ": time: is no array", 2, {0, 3}}, /* neither side is so long; see below  */
    {"time", ": cannot read time: ", 1, {5}, 'c', true},
    {"time", ": time: is no array", 3, {5, 1, 1}, 0, true},
    {"xyz", ": is not a result file", 5, {6000, 2, 100, 100, 3}}, /* 2.9 GB */
    {"xyz", ": is not a result file", 5, {1, 3, 100, 100, 3}, 0, true},
    {"xyz", ": is not a result file", 5, {1, 2, 101, 100, 3}, 0, true},
    {"xyz", ": is not a result file", 5, {1, 2, 100, 101, 3}, 0, true},
    {"xyz", ": is not a result file", 5, {1, 2, 100, 100, 4}, 0, true},
    {"xyz", ": is not a result file", 4, {1, 2, 100, 100}, 0, true}};

static const struct made garment[] = {
    {"surface", ": has no surface/triangle", 0},
    {"surface/triangle", ": has no surface/triangle", 0},
    {"surface/triangle", ": its surface is no triangles", 2, {9, 3}, 0, true},
    {"surface/triangle", ": its surface is no triangles", 2, {9, 4}, 0, true},
    {"surface/triangle", ": its surface is no triangles", 1, {9}, 0, true},
    {"surface/uv", ": has no surface/uv", 0},
    {"surface/uv", ": its surface is no triangles", 2, {9, 2}, 0, true},
    {"surface/uv", ": its surface is no triangles", 2, {9, 3}, 0, true},
    {"surface/uv", ": its surface is no triangles", 0, {0}, 'n'},
    {"surface/start", ": its surface is no triangles", 2, {9, 3}, 0, true},
    {"surface/start", ": its surface is no triangles", 0, {0}, 'n'},
    {"corner_u", ": its surface is no triangles", 0, {0}, 'm'},
    {"length", ": its surface is no triangles", 0, {0}, 'm'},
    {"width", ": has no number width", 0, {0}, 'a'},
    {"support_0", ": support_0 is no triangles", 2, {9, 5}, 0, true},
    {"support_0", ": support_0 is no triangles", 0, {0}, 'n'}};

/* Writes NaN in place of all numbers that an array or an attribute has. */
static void spoil(hid_t file, const struct made *m)
{
    static double nothing[30000];
    hid_t id = m->kind == 'm' ? H5Aopen(file, m->name, H5P_DEFAULT)
                              : H5Dopen2(file, m->name, H5P_DEFAULT);

    for (int n = 0; n < 30000; n++)
        nothing[n] = NAN;
    REQUIRE(m->kind == 'm' || H5Dget_storage_size(id) <= sizeof nothing);
    REQUIRE((m->kind == 'm' ? H5Awrite(id, H5T_NATIVE_DOUBLE, nothing)
                            : H5Dwrite(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                       nothing)) >= 0);
    H5Idec_ref(id);
}

/* Replaces what has that name; `least` takes the place of a side of 0. */
static void put(hid_t file, const struct made *m, hsize_t least)
{
    static const double zeros[100000]; /* one frame has 60,000 */
    const bool attribute = m->kind == 'a' || m->kind == 't';
    const hid_t type = m->kind == 't' || m->kind == 'c' ? H5T_C_S1 : H5T_NATIVE_DOUBLE;
    hsize_t size[5], chunk[5] = {1, 1, 1, 1, 1};

    if (m->kind == 'n' || m->kind == 'm') {
        spoil(file, m);
        return;
    }
    REQUIRE((attribute ? H5Adelete(file, m->name)
                       : H5Ldelete(file, m->name, H5P_DEFAULT)) >= 0);
    if (!m->rank)
        return;
    hid_t create = H5Pcreate(H5P_DATASET_CREATE);
    for (int n = 0; n < m->rank; n++)
        size[n] = m->size[n] ? m->size[n] : least;
    hid_t space = H5Screate_simple(m->rank, size, NULL);
    if (!m->zeros)
        H5Pset_chunk(create, m->rank, chunk);
    hid_t id = attribute ? H5Acreate2(file, m->name, type, space, H5P_DEFAULT, H5P_DEFAULT)
                         : H5Dcreate2(file, m->name, type, space, H5P_DEFAULT, create,
                                      H5P_DEFAULT);
    REQUIRE(id >= 0);
    if (m->zeros)
        REQUIRE((attribute
                     ? H5Awrite(id, type, zeros)
                     : H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros)) >= 0);
    H5Idec_ref(id);
    H5Pclose(create);
    H5Sclose(space);
}

/* Reads runs that were changed so: the sentence begins with the file's name and has a part.
 */
static void made_on_purpose(const char *good, const char *bad, size_t count,
                            const struct made *with)
{
    long size;
    unsigned char *bytes = read_all(good, &size);

    for (size_t n = 0; n < count; n++) {
        struct message why = {""};
        text_put(bad, bytes, (size_t)size);
        hid_t file = H5Fopen(bad, H5F_ACC_RDWR, H5P_DEFAULT);
        REQUIRE(file >= 0);
        put(file, &with[n], (hsize_t)size - 2000);
        REQUIRE(H5Fclose(file) >= 0 && seal_write(bad, NULL) == STATUS_OK);
        CHECK(read_run(bad, &why) != STATUS_OK);
        CHECK_SAY(!strncmp(why.text, bad, strlen(bad)) && !strchr(why.text, '\n') &&
                      strstr(why.text, with[n].part),
                  "%s, %s, said: %s", with[n].name, with[n].part, why.text);
    }
    free(bytes);
}

int main(void)
{
    scratch_open();
    const char *good = scratch_path("run.h5"), *bad = scratch_path("damaged.h5");
    make_run(good, "iga_linear", "edge_drop");
    try_all(good, bad, read_run);
    made_on_purpose(good, bad, sizeof made / sizeof *made, made);
    make_run(good, "triangles", "skirt");
    CHECK(read_run(good, NULL) == STATUS_OK);
    made_on_purpose(good, bad, sizeof garment / sizeof *garment, garment);
    try_all(SOURCE_DIR "/bench/truths/sphere.h5", bad, read_truth);
    return check_result();
}
