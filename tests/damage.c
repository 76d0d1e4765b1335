/* Result files that were damaged on the way - bits, bytes, pieces lost or put in - are told
 * in a sentence: 2,000 stored truths and 2,000 runs, with a fixed seed. None is believed,
 * none crashes what reads it.
 *   test_damage FOLDER
 */
#include <sys/stat.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/harness/contestant.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"

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

static void write_all(const char *path, const unsigned char *bytes, long size)
{
    FILE *file = fopen(path, "wb");

    REQUIRE(file && fwrite(bytes, 1, (size_t)size, file) == (size_t)size);
    REQUIRE(fclose(file) == 0);
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
        write_all(bad, copy, damage(copy, size));
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
    char *physics = NULL;
    const enum status st = truth_file_read(path, &made, &physics, why);

    if (st == STATUS_OK)
        truth_clear(&made);
    free(physics);
    return st;
}

static enum status read_run(const char *path, struct message *why)
{
    struct run_result r = {0};
    const enum status st = run_result_read(path, true, &r, why);

    run_result_clear(&r);
    return st;
}

static void make_run(const char *path)
{
    struct run_plan plan = {.end = 0.02};
    char *scene = NULL;

    REQUIRE(contestant_find("iga_linear", &plan.contestant, NULL) == STATUS_OK);
    REQUIRE(scene_file_find("edge_drop", &scene, NULL) == STATUS_OK);
    plan.path = scene;
    REQUIRE(run_file_write(&plan, &(struct run_keep){.file = path, .every = 1}, NULL,
                           NULL) == STATUS_OK);
    free(scene);
}

/* --- Files that somebody made on purpose, sealed as ours: a text that is many, a number
 * that is many, arrays far larger than their file. */

/* In place of an attribute 4000 of its type. */
static void many(hid_t file, const char *key, hid_t type)
{
    static const double zeros[4000];
    const hsize_t count = 4000;
    hid_t space = H5Screate_simple(1, &count, NULL);

    H5Adelete(file, key);
    hid_t attribute = H5Acreate2(file, key, type, space, H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(attribute >= 0 && H5Awrite(attribute, type, zeros) >= 0);
    H5Aclose(attribute);
    H5Sclose(space);
}

static void many_texts(hid_t file)
{
    many(file, "outcome", H5T_C_S1);
}

static void many_numbers(hid_t file)
{
    many(file, "unknowns", H5T_NATIVE_DOUBLE);
}

/* In place of an array one of another type, rank or size: zeros, or nothing written. */
static void replace(hid_t file, const char *name, hid_t type, int rank, const hsize_t *size,
                    const void *zeros)
{
    hsize_t chunk[5] = {1, 1, 1, 1, 1};
    hid_t space = H5Screate_simple(rank, size, NULL),
          create = H5Pcreate(H5P_DATASET_CREATE);

    chunk[rank - 1] = 3;
    H5Pset_chunk(create, rank, zeros ? size : chunk);
    H5Ldelete(file, name, H5P_DEFAULT);
    hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, create, H5P_DEFAULT);
    REQUIRE(set >= 0);
    REQUIRE(!zeros || H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros) >= 0);
    H5Dclose(set);
    H5Pclose(create);
    H5Sclose(space);
}

static void large_array(hid_t file)
{
    replace(file, "time", H5T_NATIVE_DOUBLE, 2, (hsize_t[]){1ul << 32, 1ul << 32},
            NULL); /* the product is 0 */
}

static void many_frames(hid_t file)
{
    replace(file, "xyz", H5T_NATIVE_DOUBLE, 5, (hsize_t[]){6000, 2, 100, 100, 3},
            NULL); /* 2.9 GB */
}

static hsize_t file_size;

/* Neither side is too large, the whole is. */
static void thick_array(hid_t file)
{
    replace(file, "time", H5T_NATIVE_DOUBLE, 2, (hsize_t[]){file_size - 2000, 3}, NULL);
}

static double zeros[100000]; /* one frame has 60,000 */

static void letters(hid_t file)
{
    replace(file, "time", H5T_C_S1, 1, (hsize_t[]){5}, zeros);
}

static void box(hid_t file)
{
    replace(file, "time", H5T_NATIVE_DOUBLE, 3, (hsize_t[]){5, 1, 1}, zeros);
}

/* Fields of any shape but ours, in each direction. */
static hsize_t shape[5];
static int shape_rank;

static void other_shape(hid_t file)
{
    replace(file, "xyz", H5T_NATIVE_DOUBLE, shape_rank, shape, zeros);
}

/* The run changed by `make`: the sentence begins with the file's name and has a part. */
static void check_made(const unsigned char *bytes, long size, const char *bad,
                       void (*make)(hid_t file), const char *part)
{
    struct message why = {""};

    write_all(bad, bytes, size);
    hid_t file = H5Fopen(bad, H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(file >= 0);
    make(file);
    REQUIRE(H5Fclose(file) >= 0);
    REQUIRE(seal_write(bad, NULL) == STATUS_OK);
    CHECK(read_run(bad, &why) != STATUS_OK);
    printf("  said: %s\n", why.text);
    CHECK(!strncmp(why.text, bad, strlen(bad)) && !strchr(why.text, '\n'));
    CHECK(strstr(why.text, part));
}

static void made_on_purpose(const char *good, const char *bad)
{
    static const struct {
        void (*make)(hid_t file);
        const char *part;
    } made[] = {{many_texts, ": has no text outcome"},
                {many_numbers, ": has no number unknowns"},
                {large_array, ": time is larger than the file"},
                {thick_array, ": time is larger than the file"},
                {many_frames, ": is not a result file"},
                {letters, ": cannot read time: "},
                {box, ": cannot read time: "}};
    static const hsize_t ours[5] = {1, 2, 100, 100, 3};
    long size;
    unsigned char *bytes = read_all(good, &size);

    file_size = (hsize_t)size;
    for (size_t n = 0; n < sizeof made / sizeof *made; n++)
        check_made(bytes, size, bad, made[n].make, made[n].part);
    for (int axis = 1; axis <= 5; axis++) { /* the last: of rank 4 */
        memcpy(shape, ours, sizeof shape);
        shape_rank = axis < 5 ? 5 : 4;
        if (axis < 5)
            shape[axis]++;
        check_made(bytes, size, bad, other_shape, ": is not a result file");
    }
    free(bytes);
}

int main(int argc, char **argv)
{
    char good[4096], bad[4096];

    REQUIRE(argc == 2);
    mkdir(argv[1], 0777);
    snprintf(good, sizeof good, "%s/run.h5", argv[1]);
    snprintf(bad, sizeof bad, "%s/damaged.h5", argv[1]);
    make_run(good);
    try_all(good, bad, read_run);
    made_on_purpose(good, bad);
    try_all(SOURCE_DIR "/bench/truths/sphere.h5", bad, read_truth);
    remove(bad);
    return check_result();
}
