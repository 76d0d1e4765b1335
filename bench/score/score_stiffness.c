#include "bench/score/score_stiffness.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "models/grid.h"
#include "models/vector.h"

/* Columns of the grid next to the held edge and to the free one that are not used: a clamp
 * keeps a sheet from contracting and may give way, and a free edge has hardly any stress.
 */
enum { CLAMP = GRID_U / 5, FREE = GRID_U / 20 };

/* A larger share of the strain that no stiffness explains means that it is not at rest. */
static const double LEFT_MOST = 0.1;

/* The sheet's middle line: means over the width. */
struct line {
    double x[GRID_U][3];
    double step;   /* between columns at rest                                     [m]     */
    double weight; /* per area                                                  [N/m^2]   */
    double down[3]; /* direction of gravity */
};

static void line_make(const struct scene *scene, const double *field, struct line *line)
{
    const double g = vector_length(scene->gravity);

    line->step = scene->length / (GRID_U - 1);
    line->weight = scene->density * scene->thickness * g;
    for (int c = 0; c < 3; c++)
        line->down[c] = scene->gravity[c] / g;
    memset(line->x, 0, sizeof line->x);
    for (int n = 0; n < SCORE_POINTS; n++)
        for (int c = 0; c < 3; c++)
            line->x[n % GRID_U][c] += field[3 * n + c] / GRID_V;
}

static double along(const struct line *line, int i, const double direction[3])
{
    return vector_dot(line->x[i], direction);
}

/* Sums of force times force, force times strain, and strain times strain. */
struct sums {
    double ff, fe, ee;
};

static void sums_add(struct sums *s, double force, double strain)
{
    s->ff += force * force;
    s->fe += force * strain;
    s->ee += strain * strain;
}

/* Compares the nominal stress over the modulus, l (l^2 - 1) / 2 at the stretch l, with the
 * weight that hangs below. */
static struct sums pull(const struct line *line)
{
    struct sums s = {0};

    for (int i = CLAMP; i < GRID_U - 1 - FREE; i++) {
        const double l =
            (along(line, i + 1, line->down) - along(line, i, line->down)) / line->step;
        sums_add(&s, line->weight * line->step * (GRID_U - 1.5 - i), l * (l * l - 1) / 2);
    }
    return s;
}

/* Compares the angle through which the line has turned since the first column used with the
 * integral of the moment of the weight further out; both without their mean, so that the
 * clamp's own angle does not matter. */
static struct sums bend(const struct scene *scene, const struct line *line)
{
    enum { USED = GRID_U - 1 - FREE - CLAMP };
    double turned[USED], moment[USED], means[2] = {0}, out = 0, sum = 0;
    struct sums s = {0};

    for (int i = GRID_U - 1; i >= CLAMP; i--) {
        const double x = along(line, i, scene->axis_u);
        out += i < GRID_U - 1 ? x + along(line, i + 1, scene->axis_u) : 0;
        const int beyond = GRID_U - 1 - i; /* out / 2: the points' sum, trapezoidal */
        if (i - CLAMP < USED)
            moment[i - CLAMP] = line->weight * line->step * (out / 2 - beyond * x);
    }
    for (int n = 0; n < USED; n++) {
        double to[3];
        vector_between(line->x[CLAMP + n], line->x[CLAMP + n + 1], to);
        turned[n] = atan2(vector_dot(to, line->down), vector_dot(to, scene->axis_u));
        sum += line->step * moment[n];
        moment[n] = sum; /* its integral to the middle of the chord */
        means[0] += moment[n] / USED, means[1] += turned[n] / USED;
    }
    for (int n = 0; n < USED; n++)
        sums_add(&s, moment[n] - means[0], turned[n] - means[1]);
    return s;
}

static enum score_along direction(const struct scene *scene, const struct law *law)
{
    if (law->isotropic || !law_is_aligned(law))
        return SCORE_ALONG_U;
    return fmod(scene->fabric.warp, 180) == 0 ? SCORE_ALONG_WARP : SCORE_ALONG_WEFT;
}

void score_stiffness_text(const struct score_stiffness *s, char text[SCORE_STIFFNESS_TEXT])
{
    static const char *const along[] = {"u", "the warp", "the weft"};

    if (!s->found)
        snprintf(text, SCORE_STIFFNESS_TEXT,
                 "No stiffness explains its last shape, which must be one at rest (%.2g %% "
                 "is left, beside what the net leaves): does it still move?",
                 100 * s->left);
    else
        snprintf(text, SCORE_STIFFNESS_TEXT,
                 "Its %s is as stiff as %.4g N%sm along %s, %.3g times the scene's %.4g.",
                 s->part == LAW_MEMBRANE ? "membrane" : "bending", s->value,
                 s->part == LAW_MEMBRANE ? "/" : " ", along[s->along], s->value / s->scene,
                 s->scene);
}

/* Returns the share of the squared strain that no stiffness explains. */
static double unexplained(const struct sums *s)
{
    return fmax(0, 1 - s->fe * s->fe / (s->ff * s->ee));
}

/* The truth between the net's vertices is measured in the same way: what its cells make of
 * the strain is no flaw of the frames, and cancels. */
void score_stiffness_make(const struct score *score, struct score_stiffness *stiffness)
{
    const struct scene *scene = &score->truth->scene;
    const struct law law = scene_law(scene);
    struct line got, seen;

    *stiffness = (struct score_stiffness){0};
    if (!score->times || !score->truth->known.closed || !scene_is_cantilever(scene))
        return;
    line_make(scene, score->row[score->times - 1].got, &got);
    line_make(scene, score->row[score->times - 1].seen, &seen);
    const bool hangs = vector_dot(got.down, scene->axis_u) > 0.5;
    const struct sums s = hangs ? pull(&got) : bend(scene, &got),
                      net = hangs ? pull(&seen) : bend(scene, &seen);
    stiffness->applies = true;
    stiffness->part = hangs ? LAW_MEMBRANE : LAW_BENDING;
    stiffness->along = direction(scene, &law);
    stiffness->scene = law_narrow(law.matrix[stiffness->part]);
    stiffness->value = stiffness->scene * (s.ff / s.fe) / (net.ff / net.fe);
    stiffness->left = sqrt(fmax(0, unexplained(&s) - unexplained(&net)));
    stiffness->found = stiffness->value > 0 && stiffness->left <= LEFT_MOST;
}
