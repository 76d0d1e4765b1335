#include "bench/export/export_parts.h"

#include <math.h>
#include <stdlib.h>

#include "models/mechanics/supports.h"

/* Allowances for round-off: of a vertex's parameter, and of a direction. */
static const double ROUNDING = 1e-12;

/* Steps to the neighbours inside of an edge, before and after along u and v. */
static const int STEP[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};

static bool is_whole(const struct scene_support *s)
{
    return s->lo[2] <= 0 && s->hi[2] >= 1;
}

static bool reaches(const struct export_sheet *s, const struct scene_support *support,
                    int i, int j)
{
    double uvw[3], x[3];

    export_sheet_point(s, i, j, uvw, x);
    for (int d = 0; d < 2; d++)
        if (uvw[d] < support->lo[d] - ROUNDING || uvw[d] > support->hi[d] + ROUNDING)
            return false;
    return true;
}

/* Returns the components that supports through the whole thickness fix at the vertex. */
static unsigned held_whole(const struct export_sheet *s, int i, int j)
{
    unsigned fix = 0;

    for (int n = 0; export_sheet_has(s, i, j) && n < s->scene->support_count; n++)
        if (is_whole(&s->scene->supports[n]) && reaches(s, &s->scene->supports[n], i, j))
            fix |= s->scene->supports[n].fix;
    return fix;
}

/* Returns whether all components of a direction are fixed. */
static bool has_direction(unsigned fix, const double from[3], const double to[3])
{
    double length = 0;
    bool all = true;

    for (int c = 0; c < 3; c++)
        length = hypot(length, to[c] - from[c]);
    for (int c = 0; c < 3; c++)
        all &= (fix >> c & 1) || fabs(to[c] - from[c]) <= ROUNDING * length;
    return all;
}

/* Returns whether the vertex's fixed components keep the sheet from turning towards `step`.
 */
static bool is_stiff(const struct export_sheet *s, int i, int j, const int step[2])
{
    double uvw[3], here[3], there[3];

    export_sheet_point(s, i, j, uvw, here);
    export_sheet_point(s, i + step[0], j + step[1], uvw, there);
    return has_direction(held_whole(s, i, j), here, there);
}

/* Returns whether the vertex is in the sheet and not fixed along its normal. */
static bool may_leave(const struct export_sheet *s, int i, int j)
{
    double uvw[3], low[3], high[3];

    if (!export_sheet_has(s, i, j))
        return false;
    export_sheet_point(s, i, j, uvw, low);
    uvw[2] = 0, scene_rest_point(s->scene, uvw, low);
    uvw[2] = 1, scene_rest_point(s->scene, uvw, high);
    return !has_direction(held_whole(s, i, j), low, high);
}

static enum status check_thickness(const struct scene *scene, struct message *why)
{
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        if (!is_whole(s) && !(s->lo[2] == 0.5 && s->hi[2] == 0.5))
            return status_fail(
                why, STATUS_UNSUPPORTED,
                "supports[%d] holds w from %g to %g: vertices of a "
                "mid-surface say the whole thickness (a clamp) or w = 0.5 (a "
                "hinge)",
                n, s->lo[2], s->hi[2]);
    }
    return STATUS_OK;
}

/* Says which support (the first) ends between vertices, as a doubt for the user. */
static void doubt_ends(const struct export_sheet *s, struct export_held *held)
{
    for (int n = s->scene->support_count - 1; n >= 0; n--)
        for (int k = 3; k >= 0; k--) {
            const struct scene_support *support = &s->scene->supports[n];
            const double at = k % 2 ? support->hi[k / 2] : support->lo[k / 2];
            double along = at;
            if (k / 2 == 0)
                scene_sheet_at(s->scene, at, &along);
            const double cells = along * (s->points[k / 2] - 1);
            if (fabs(cells - round(cells)) > 1e-9)
                status_fail(&held->doubt, STATUS_OK,
                            "supports[%d] ends at %c = %g, between vertices: the net holds "
                            "up to the last one within",
                            n, "uv"[k / 2], along);
        }
}

static void add_outside(const struct export_sheet *s, struct export_held *held, int i,
                        int j, const struct export_held_vertex *beside)
{
    struct export_held_vertex *v = &held->vertex[held->count++];

    *v = *beside;
    v->vertex = export_sheet_vertices(s) + held->outside++;
    v->i = i, v->j = j;
    v->beside = beside->vertex;
}

/* Adds the clamps of one held vertex of the sheet: vertices outside of it, or says why
 * there can be none. */
static enum status add_clamps(const struct export_sheet *s, struct export_held *held,
                              const struct export_held_vertex *v, struct message *why)
{
    for (int k = 0; k < 4; k++) {
        const int *step = STEP[k], i = v->i - step[0], j = v->j - step[1];
        if (!may_leave(s, v->i + step[0], v->j + step[1]) || !is_stiff(s, v->i, v->j, step))
            continue;
        if (held_whole(s, v->i, v->j) != FIX_XYZ)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "vertex %d is held in %s through the thickness, which keeps "
                               "the sheet from turning there; vertices can say that of xyz "
                               "alone",
                               v->vertex, export_sheet_axes(v->fix));
        if (may_leave(s, i, j))
            return status_fail(why, STATUS_UNSUPPORTED,
                               "vertex %d is clamped with the sheet free on both sides of "
                               "it: held vertices cannot say that; a patch of two rows or "
                               "more can, on a net so fine",
                               v->vertex);
        if (!export_sheet_has(s, i, j))
            add_outside(s, held, i, j, v);
    }
    return STATUS_OK;
}

static void add_held(const struct export_sheet *s, const struct supports *supports, int n,
                     struct export_held *held)
{
    const int columns = export_sheet_columns(s);
    struct export_held_vertex v = {
        n, export_sheet_place(s, n % columns), n / columns, 0, -1, -1};

    for (int c = 0; c < 3; c++)
        if (supports->free_index[3 * n + c] < 0)
            v.fix |= 1u << c;
    if (v.fix)
        held->vertex[held->count++] = v;
}

static void add_paths(const struct scene *scene, const struct supports *supports,
                      struct export_held *held)
{
    int at = 0;

    for (int n = 0; n < supports->held_count; n++) {
        while (held->vertex[at].vertex < supports->held[n] / 3)
            at++;
        const int owner = supports->owner[n];
        if (SCENE_MOVES(scene->supports[owner].motion))
            held->vertex[at].support = owner;
    }
}

/* Finds the supports' vertices by the rule that all models share. */
static enum status find_supports(const struct export_sheet *s, struct supports *supports,
                                 struct message *why)
{
    const int vertices = export_sheet_vertices(s);
    double(*uvw)[3] = malloc(2 * (size_t)vertices * sizeof *uvw);
    double(*rest)[3] = uvw ? uvw + vertices : NULL;
    enum status st = STATUS_MEMORY;

    if (!uvw)
        return st;
    for (int n = 0; n < vertices; n++)
        export_sheet_vertex(s, n, uvw[n], rest[n]);
    st = supports_init(supports, s->scene, vertices, uvw, *rest, why);
    free(uvw);
    return st;
}

enum status export_held_find(const struct export_sheet *s, struct export_held *held,
                             struct message *why)
{
    const int vertices = export_sheet_vertices(s);
    struct supports supports = {0};
    enum status st;

    *held = (struct export_held){0};
    TRY(check_thickness(s->scene, why));
    TRY(find_supports(s, &supports, why));
    /* a vertex may have one outside along u and one along v */
    held->vertex = malloc(3 * ((size_t)vertices + 1) * sizeof *held->vertex);
    TRY(held->vertex ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < vertices; n++)
        add_held(s, &supports, n, held);
    add_paths(s->scene, &supports, held);
    for (int n = 0, count = held->count; n < count; n++)
        TRY(add_clamps(s, held, &held->vertex[n], why));
    doubt_ends(s, held);
out:
    supports_clear(&supports);
    if (st != STATUS_OK)
        export_held_clear(held);
    return st;
}

int export_held_path(const struct export_job *j, int n)
{
    const int support = j->held.vertex[n].support;

    return support < 0 || !j->scene.supports[support].motion.turn_count
               ? support
               : j->scene.support_count + n;
}

void export_held_clear(struct export_held *held)
{
    free(held->vertex);
    *held = (struct export_held){0};
}

enum status export_held_csv(struct export_job *j, struct output *out)
{
    output_print(out, "vertex,u,v,x,y,z,fix,path,beside\n");
    for (int n = 0; n < j->held.count; n++) {
        const struct export_held_vertex *v = &j->held.vertex[n];
        double uvw[3], x[3];
        export_sheet_point(&j->sheet, v->i, v->j, uvw, x);
        output_print(out, "%d,%.17g,%.17g,%.17g,%.17g,%.17g,%s,", v->vertex, uvw[0], uvw[1],
                     x[0], x[1], x[2], export_sheet_axes(v->fix));
        const int path = export_held_path(j, n);
        output_print(out, path < 0 ? "," : "%d,", path);
        output_print(out, v->beside < 0 ? "\n" : "%d\n", v->beside);
    }
    return STATUS_OK;
}
