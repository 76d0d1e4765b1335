/* frames_fixture.h - frames written as other programs would, for tests of their readers: a
 * net of N_U x N_V vertices, TIMES of it, whose numbers are exact in 32 bits. */
#ifndef FRAMES_FIXTURE_H
#define FRAMES_FIXTURE_H

#include <hdf5.h>

#include "bench/files/hdf5_file.h"
#include "bench/frames/frames.h"
#include "tests/check.h"

enum { N_U = 5, N_V = 4, VERTICES = N_U * N_V, TIMES = 12 };

static inline void sample_uv(int n, double uv[2])
{
    uv[0] = n % N_U / (N_U - 1.);
    uv[1] = n / N_U / 4.;
}

static inline double sample_time(int k)
{
    return k / 16.;
}

static inline void sample(int k, int n, double xyz[3])
{
    double uv[2];

    sample_uv(n, uv);
    xyz[0] = uv[0] - k / 64.;
    xyz[1] = uv[1];
    xyz[2] = -k * k * (1 + uv[0]) / 128.;
}

extern const char *frames_folder; /* where files go */

static inline FILE *create(const char *name)
{
    char path[4096];

    snprintf(path, sizeof path, "%s/%s", frames_folder, name);
    FILE *file = fopen(path, "wb");
    REQUIRE(file);
    return file;
}

static inline void put_number(unsigned char **at, double x, int size, bool big)
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

static inline void put_whole(unsigned char **at, unsigned long long x, int size, bool big)
{
    for (int n = 0; n < size; n++)
        (*at)[big ? size - 1 - n : n] = (unsigned char)(n < 8 ? x >> 8 * n : 0);
    *at += size;
}

enum { ROOM = 1 << 16 };

/* An array as NumPy writes it; what = x: xyz, u: uv, t: times. Its size. */
static inline size_t sample_array(unsigned char *room, char what, int bytes,
                                  const char *type, const char *shape)
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

static inline void write_npy(const char *name, const char *type, const char *shape,
                             int bytes)
{
    unsigned char room[ROOM];
    FILE *file = create(name);
    const size_t size = sample_array(room, 'x', bytes, type, shape);

    REQUIRE(fwrite(room, 1, size, file) == size && fclose(file) == 0);
}

static inline void put_set(hid_t file, const char *name, int rank, const hsize_t *size,
                           const double *values)
{
    hid_t space = H5Screate_simple(rank, size, NULL);
    hid_t set = H5Dcreate2(file, name, H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT,
                           H5P_DEFAULT);

    REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
    H5Dclose(set);
    H5Sclose(space);
}

static inline void write_hdf5(const char *name, hsize_t rows)
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

static inline void write_text(const char *name, const char *text)
{
    FILE *file = create(name);

    REQUIRE(fputs(text, file) >= 0 && fclose(file) == 0);
}

/* The first so many bytes of another file. */
static inline void write_part(const char *name, const char *of, size_t size)
{
    char path[4096], room[ROOM];

    snprintf(path, sizeof path, "%s/%s", frames_folder, of);
    FILE *from = fopen(path, "rb"), *to = create(name);
    REQUIRE(from && fread(room, 1, size, from) == size);
    REQUIRE(fwrite(room, 1, size, to) == size && fclose(to) == 0);
    fclose(from);
}

/* Of frames_bad.c: what is refused; its check_result(). */
int frames_bad(void);

#endif
