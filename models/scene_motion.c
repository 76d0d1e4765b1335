#include "models/scene_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

static const double PI = 3.14159265358979323846;

/* Returns a copy of `bytes` bytes; NULL if there are none, *st tells of memory. */
static void *copied(const void *from, size_t bytes, enum status *st)
{
    void *copy = from && bytes ? malloc(bytes) : NULL;

    if (copy)
        memcpy(copy, from, bytes);
    else if (from && bytes)
        *st = STATUS_MEMORY;
    return copy;
}

enum status scene_motion_copy(struct scene_motion *motion, const struct scene_motion *from)
{
    enum status st = STATUS_OK;
    struct scene_motion copy = *from;

    copy.path = copied(from->path, (size_t)from->path_count * sizeof *from->path, &st);
    copy.turn = copied(from->turn, (size_t)from->turn_count * sizeof *from->turn, &st);
    if (st != STATUS_OK)
        scene_motion_clear(&copy);
    *motion = copy;
    return st;
}

void scene_motion_clear(struct scene_motion *motion)
{
    free(motion->path);
    free(motion->turn);
    *motion = (struct scene_motion){0};
}

void scene_motion_table(int rows, int columns, const double *table, double t, double *value)
{
    int k = 0, high = rows; /* rows before k are at or before t, rows from high on after */

    while (k < high) {
        const int middle = (k + high) / 2;

        if (table[middle * columns] <= t)
            k = middle + 1;
        else
            high = middle;
    }
    const int before = k > 0 ? k - 1 : 0, after = k < rows ? k : rows - 1;

    for (int i = 1; i < columns; i++) {
        value[i - 1] = rows > 0 ? table[before * columns + i] : 0;
        if (before < after)
            value[i - 1] += (t - table[before * columns]) /
                            (table[after * columns] - table[before * columns]) *
                            (table[after * columns + i] - table[before * columns + i]);
    }
}

/* Sets turn to the rotation by an angle about a unit axis (Rodrigues). */
static void rotation(const double axis[3], double angle, double turn[3][3])
{
    const double c = cos(angle), s = sin(angle);

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int sign = (j - i + 3) % 3 == 1 ? -1 : (j - i + 3) % 3 == 2 ? 1 : 0;
            turn[i][j] = (1 - c) * axis[i] * axis[j] + (i == j) * c +
                         (sign ? sign * s * axis[3 - i - j] : 0);
        }
}

void scene_motion_at(const struct scene_motion *motion, double t,
                     struct scene_placement *place)
{
    double shift[3], angle;

    *place = (struct scene_placement){.turn = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    scene_motion_table(motion->path_count, 4, (const double *)motion->path, t, shift);
    scene_motion_table(motion->turn_count, 2, (const double *)motion->turn, t, &angle);
    if (angle != 0)
        rotation(motion->axis, angle * PI / 180, place->turn);
    for (int i = 0; i < 3; i++)
        place->shift[i] =
            shift[i] +
            (angle != 0 ? motion->about[i] - vector_dot(place->turn[i], motion->about) : 0);
}

void scene_placement_turn(const struct scene_placement *place, const double d[3],
                          double turned[3])
{
    for (int i = 0; i < 3; i++)
        turned[i] = vector_dot(place->turn[i], d);
}

void scene_placement_point(const struct scene_placement *place, const double X[3],
                           double x[3])
{
    scene_placement_turn(place, X, x);
    for (int i = 0; i < 3; i++)
        x[i] += place->shift[i];
}

void scene_placement_back(const struct scene_placement *place, const double x[3],
                          double X[3])
{
    double d[3];

    vector_between(place->shift, x, d);
    for (int i = 0; i < 3; i++)
        X[i] =
            place->turn[0][i] * d[0] + place->turn[1][i] * d[1] + place->turn[2][i] * d[2];
}
