/* Datasets that somebody made on purpose: only those are read whose numbers stand in the
 * file itself, all of them, in pieces that are not much more than a frame. */
#include <unistd.h>

#include "bench/files/hdf5_file.h"
#include "tests/check.h"
#include "tests/scratch.h"

enum { ROWS = 4, COLUMNS = 3 };

static hid_t make(hid_t file, const char *name, hid_t list, bool written)
{
    static const hsize_t size[2] = {ROWS, COLUMNS};
    static const double value[ROWS][COLUMNS] = {{1}};
    static const hsize_t most[2] = {H5S_UNLIMITED, H5S_UNLIMITED};
    const bool pieces = H5Pget_layout(list) == H5D_CHUNKED;
    const hid_t space = H5Screate_simple(2, size, pieces ? most : NULL);
    const hid_t set =
        H5Dcreate2(file, name, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT);

    REQUIRE(set >= 0);
    if (written)
        REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, value) >=
                0);
    hdf5_file_drop(space);
    hdf5_file_drop(list);
    return set;
}

static hid_t a_list(void)
{
    return H5Pcreate(H5P_DATASET_CREATE);
}

static hid_t pieces_of(hsize_t rows, hsize_t columns)
{
    const hid_t list = a_list();

    REQUIRE(H5Pset_chunk(list, 2, (hsize_t[]){rows, columns}) >= 0);
    return list;
}

static hid_t packed(void)
{
    const hid_t list = pieces_of(1, COLUMNS);

    REQUIRE(H5Pset_deflate(list, 1) >= 0);
    return list;
}

static hid_t outside(void)
{
    const hid_t list = a_list();

    REQUIRE(H5Pset_external(list, "/etc/hostname", 0, H5F_UNLIMITED) >= 0);
    return list;
}

static hid_t of_itself(void)
{
    static const hsize_t size[2] = {ROWS, COLUMNS};
    const hid_t list = a_list(), space = H5Screate_simple(2, size, NULL);

    REQUIRE(H5Pset_virtual(list, space, ".", "virtual", space) >= 0);
    hdf5_file_drop(space);
    return list;
}

static void write_sets(const char *path, const char *other)
{
    const hid_t elsewhere = H5Fcreate(other, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t file = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t group = H5Gcreate2(file, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);

    REQUIRE(file >= 0 && elsewhere >= 0 && group >= 0);
    hdf5_file_drop(make(elsewhere, "plain", a_list(), true));
    hdf5_file_drop(make(file, "plain", a_list(), true));
    hdf5_file_drop(make(file, "pieces", pieces_of(1, COLUMNS), true));
    hdf5_file_drop(make(file, "packed", packed(), true));
    hdf5_file_drop(make(file, "large", pieces_of(1 << 11, 1 << 10), true));
    hdf5_file_drop(make(file, "never", a_list(), false));
    hdf5_file_drop(make(file, "never in pieces", pieces_of(1, COLUMNS), false));
    hdf5_file_drop(make(file, "outside", outside(), false));
    hdf5_file_drop(make(file, "virtual", of_itself(), false));
    hdf5_file_drop(make(group, "inner", a_list(), true));
    REQUIRE(H5Lcreate_external(other, "plain", file, "linked", H5P_DEFAULT, H5P_DEFAULT) >=
            0);
    REQUIRE(H5Lcreate_external(other, "/", file, "far", H5P_DEFAULT, H5P_DEFAULT) >= 0);
    REQUIRE(H5Lcreate_soft("/plain", file, "soft", H5P_DEFAULT, H5P_DEFAULT) >= 0);
    hdf5_file_drop(group);
    REQUIRE(H5Fclose(file) >= 0 && H5Fclose(elsewhere) >= 0);
}

static void test_sets(const char *path)
{
    static const struct {
        const char *name;
        bool read;
    } want[] = {{"plain", true},    {"pieces", true},
                {"packed", true},   {"group/inner", true},
                {"large", false},   {"never", false},
                {"outside", false}, {"never in pieces", false},
                {"virtual", false}, {"linked", false},
                {"soft", false},    {"far/plain", false},
                {"none", false},    {"group", false}};
    const hid_t file = hdf5_file_open(path, NULL);

    REQUIRE(file >= 0);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        hsize_t size[HDF5_FILE_RANK];
        int rank = -1;
        const hid_t set = hdf5_file_open_set(file, want[n].name, &rank, size);
        if (!CHECK(want[n].read ? set >= 0 && rank == 2 && size[0] == ROWS
                                : set < 0 && rank == 0))
            printf("  %s: rank %d\n", want[n].name, rank);
        hdf5_file_drop(set);
    }
    hdf5_file_drop(file);
}

int main(void)
{
    scratch_open();
    const char *path = scratch_path("sets.h5"), *other = scratch_path("other.h5");
    struct message why = {""};

    hdf5_file_start();
    write_sets(path, other);
    test_sets(path);
    CHECK(hdf5_file_open(scratch, &why) < 0 && strstr(why.text, "it is a directory"));
    unlink(path);
    unlink(other);
    return check_result();
}
