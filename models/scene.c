/* scene.c - makes, copies and evaluates scenes. scene_file.c reads them. */
#include "models/scene.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/pattern.h"
#include "models/vector.h"

/* So near, in shares of the box, a place is at a part of a support. */
static const double ON_PART = 1e-9;

/* The round-off of u, in columns of the grid. */
#define ROUND_OFF 1e-12

void scene_clear(struct scene *scene)
{
    for (int i = 0; i < scene->support_count; i++)
        scene_support_clear(&scene->supports[i]);
    free(scene->supports);
    free(scene->loads);
    for (int i = 0; i < scene->obstacle_count; i++)
        scene_obstacle_clear(&scene->obstacles[i]);
    free(scene->obstacles);
    free(scene->snapshots);
    free(scene->air.wind);
    free(scene->name);
    free(scene->source);
    free(scene->about);
    free(scene->text);
    pattern_free(scene->pattern);
    free(scene->pattern_file);
    memset(scene, 0, sizeof *scene);
}

enum status scene_init(struct scene *scene)
{
    *scene = (struct scene){
        .name = strdup("unit"),
        .source = strdup("made in memory"),
        .text = strdup(""),
        .length = 1.0,
        .width = 1.0,
        .thickness = 0.01,
        .sheets = 1,
        .axis_u = {1, 0, 0},
        .axis_v = {0, 1, 0},
        .young = 1.0,
        .density = 1.0,
        .step = 0.005,
        .end = 1.0,
    };
    if (scene->name && scene->source && scene->text)
        return STATUS_OK;
    scene_clear(scene);
    return STATUS_MEMORY;
}

/* Makes room for one more of `size` bytes behind array[count]. NULL without memory; the
 * array then stays. */
static void *grow(void *array, int count, size_t size)
{
    return realloc(array, ((size_t)count + 1) * size);
}

bool scene_support_has(const struct scene_support *s, double u, double v)
{
    const double p[2] = {u, v};
    bool has = !s->part_count;

    for (int n = 0; !has && n < s->part_count; n++) {
        int left = 0;
        for (int k = 0; k < 3; k++) {
            const double *a = s->part[n][k], *b = s->part[n][(k + 1) % 3];
            has |= mesh_flat_off2(a, b, p) <= ON_PART * ON_PART;
            left += mesh_flat_left(a, b, p) > 0;
        }
        has |= left == 3;
    }
    return has;
}

void scene_support_clear(struct scene_support *s)
{
    scene_motion_clear(&s->motion);
    free(s->part);
    s->part = NULL, s->part_count = 0;
}

enum status scene_add_support(struct scene *scene, const struct scene_support *support)
{
    enum status st;
    struct scene_support copy = *support;
    struct scene_support *s = grow(scene->supports, scene->support_count, sizeof *s);

    if (!s)
        return STATUS_MEMORY;
    scene->supports = s;
    copy.part = NULL, copy.motion = (struct scene_motion){0};
    if (copy.part_count) {
        const size_t size = (size_t)copy.part_count * sizeof *copy.part;
        copy.part = malloc(size);
        if (!copy.part)
            return STATUS_MEMORY;
        memcpy(copy.part, support->part, size);
    }
    st = scene_motion_copy(&copy.motion, &support->motion);
    if (st == STATUS_OK)
        s[scene->support_count++] = copy;
    else
        scene_support_clear(&copy);
    return st;
}

enum status scene_add_load(struct scene *scene, const struct scene_load *load)
{
    struct scene_load *l = grow(scene->loads, scene->load_count, sizeof *l);

    if (l)
        scene->loads = l, l[scene->load_count++] = *load;
    return l ? STATUS_OK : STATUS_MEMORY;
}

enum status scene_add_obstacle(struct scene *scene, const struct scene_obstacle *obstacle)
{
    enum status st;
    struct scene_obstacle copy = *obstacle;
    struct scene_obstacle *o = grow(scene->obstacles, scene->obstacle_count, sizeof *o);
    const char *file = obstacle->file;

    if (!o)
        return STATUS_MEMORY;
    scene->obstacles = o;
    st = scene_motion_copy(&copy.motion, &obstacle->motion);
    copy.file = file ? strdup(file) : NULL;
    if (file && !copy.file)
        st = STATUS_MEMORY;
    if (st == STATUS_OK) {
        o[scene->obstacle_count++] = copy;
        return st;
    }
    copy.mesh = NULL; /* still the caller's */
    scene_obstacle_clear(&copy);
    return st;
}

void scene_obstacle_clear(struct scene_obstacle *o)
{
    scene_motion_clear(&o->motion);
    free(o->file);
    free(o->mesh);
    *o = (struct scene_obstacle){.kind = o->kind};
}

static unsigned support_needs(const struct scene_support *s)
{
    unsigned needs = 0;

    if (scene_grips(s))
        needs |= SCENE_NEED_GRIPPERS;
    if (SCENE_MOVES(s->motion))
        needs |= SCENE_NEED_MOVING_SUPPORTS;
    if (s->motion.turn_count > 0 && s->lo[2] < s->hi[2] && !scene_grips(s))
        needs |= SCENE_NEED_TURNING_CLAMPS;
    if (s->hi[0] > s->lo[0] && s->hi[1] > s->lo[1])
        needs |= SCENE_NEED_PATCH_SUPPORTS;
    if (s->fix != FIX_XYZ)
        needs |= SCENE_NEED_COMPONENT_SUPPORTS;
    if (s->lo[2] > 0 || s->hi[2] < 1)
        needs |= SCENE_NEED_THICKNESS_SUPPORTS;
    return needs;
}

unsigned scene_needs(const struct scene *scene)
{
    unsigned needs = 0;

    for (int i = 0; i < scene->support_count; i++)
        needs |= support_needs(&scene->supports[i]);
    if (scene->obstacle_count > 0)
        needs |= SCENE_NEED_CONTACT;
    for (int i = 0; i < scene->obstacle_count; i++)
        if (SCENE_MOVES(scene->obstacles[i].motion))
            needs |= SCENE_NEED_MOVING_OBSTACLES;
    if (scene->contact.self)
        needs |= SCENE_NEED_SELF_CONTACT;
    if (scene->sheets > 1)
        needs |= SCENE_NEED_SHEETS;
    for (int k = 0; k < scene->sheets; k++)
        if (scene->own[k].density > 0)
            needs |= SCENE_NEED_OWN_MATERIALS;
    if (scene->load_count > 0)
        needs |= SCENE_NEED_LOADS;
    if (scene->pattern)
        needs |= SCENE_NEED_OUTLINE;
    if (scene->pressure != 0)
        needs |= SCENE_NEED_PRESSURE;
    if (scene->drag > 0)
        needs |= SCENE_NEED_DRAG;
    if (scene->air.density > 0)
        needs |= SCENE_NEED_AIR;
    if (scene->shape != SCENE_FLAT)
        needs |= SCENE_NEED_CURVED_REST;
    if (scene_closed(scene))
        needs |= SCENE_NEED_CLOSED_REST;
    if (scene->is_fabric)
        needs |= SCENE_NEED_FABRIC;
    if (scene->is_fabric && fmod(scene->fabric.warp, 90) != 0)
        needs |= SCENE_NEED_BIAS;
    if (scene->is_fabric &&
        (scene->fabric.softening[0] < 0 || scene->fabric.softening[1] < 0))
        needs |= SCENE_NEED_SOFTENING;
    for (int i = 0; i < 3; i++)
        if (scene->velocity[i] != 0 || scene->spin[i] != 0 || scene->ripple[i] != 0)
            needs |= SCENE_NEED_INITIAL_MOTION;
    return needs;
}

void scene_needs_text(unsigned needs, char *text, int size)
{
    static const char *const sentence[] = {
#define SENTENCE(name, words) [SCENE_NEED_BIT_##name] = words,
        SCENE_NEED_LIST(SENTENCE)
#undef SENTENCE
    };
    int used = 0;

    assert(size > 0);
    text[0] = '\0';
    for (unsigned bit = 0; bit < sizeof sentence / sizeof *sentence; bit++) {
        if (!(needs & 1u << bit) || used >= size)
            continue;
        used += snprintf(text + used, (size_t)(size - used), "%s%s", used ? ", " : "",
                         sentence[bit]);
    }
}

double scene_area(const struct scene *scene)
{
    return scene->pattern ? scene->pattern->area : scene->length * scene->width;
}

bool scene_void(const struct scene *scene, int i, int j)
{
    return scene->pattern && !scene->pattern->on[j][i];
}

const char *const scene_shape_words[] = {
    [SCENE_FLAT] = "flat", [SCENE_CLOAK] = "cloak", NULL};

int scene_sheets(const struct scene *scene)
{
    return scene->sheets > 1 ? scene->sheets : 1;
}

int scene_sheet_at(const struct scene *scene, double u, double *s)
{
    double at = u * (GRID_U - 1);
    int column[2];

    *s = u;
    if (scene->sheets < 2)
        return 0;
    const double nearest = round(fmin(fmax(at, 0), GRID_U - 1));
    const int sheet = grid_sheet(scene->sheets, (int)nearest);
    grid_columns(scene->sheets, sheet, column);
    if (fabs(at - nearest) < ROUND_OFF)
        at = nearest;
    *s = fmin(fmax((at - column[0]) / (column[1] - column[0]), 0), 1);
    return sheet;
}

double scene_sheet_u(const struct scene *scene, int sheet, double s)
{
    int column[2];

    if (scene->sheets < 2)
        return s;
    grid_columns(scene->sheets, sheet, column);
    return (column[0] + s * (column[1] - column[0])) / (GRID_U - 1);
}

struct scene_support scene_support_along(const struct scene *scene, int support)
{
    struct scene_support s = scene->supports[support];

    scene_sheet_at(scene, s.lo[0], &s.lo[0]);
    scene_sheet_at(scene, s.hi[0], &s.hi[0]);
    return s;
}

double scene_sheet_inside(const struct scene *scene, double u)
{
    double s;

    if (scene->sheets < 2)
        return u;
    const int sheet = scene_sheet_at(scene, u, &s);
    return scene_sheet_u(scene, sheet, s);
}

const char *scene_sheet_other(const struct scene *scene)
{
    return scene->sheets > 1 ? "itself or another sheet" : "itself";
}

int scene_sheet_of(const struct scene *scene, int item, int items)
{
    return item / (items / scene_sheets(scene));
}

struct scene scene_sheet(const struct scene *scene, int sheet)
{
    const struct scene_own *own = &scene->own[sheet];
    struct scene one = *scene;

    one.sheets = 1;
    one.pose[0] = scene->pose[sheet];
    if (own->density > 0) {
        one.young = own->young;
        one.poisson = own->poisson;
        one.density = own->density;
    }
    return one;
}

void scene_normal(const struct scene *scene, double e_w[3])
{
    vector_cross(scene->axis_u, scene->axis_v, e_w);
}

void scene_pose_point(const struct scene *scene, const double place[3], double xyz[3])
{
    const struct scene_pose *pose = &scene->pose[0];
    double e_w[3];

    vector_cross(pose->axis_u, pose->axis_v, e_w);
    for (int i = 0; i < 3; i++)
        xyz[i] = pose->origin[i] + place[0] * pose->axis_u[i] + place[1] * pose->axis_v[i] +
                 place[2] * e_w[i];
}

bool scene_starts_flat(const struct scene *scene)
{
    return scene->shape == SCENE_FLAT && !pattern_starts_in_space(scene->pattern);
}

static void begin_in_space(const struct scene *scene, const double uvw[3], double xyz[3])
{
    double place[3], normal[3];

    pattern_begin(scene->pattern, uvw[0] * scene->length, uvw[1] * scene->width, place,
                  normal);
    for (int i = 0; i < 3; i++)
        place[i] += (uvw[2] - 0.5) * scene->thickness * normal[i];
    scene_pose_point(scene, place, xyz);
}

void scene_rest_point(const struct scene *scene, const double uvw[3], double xyz[3])
{
    double e_w[3], s;

    if (scene->shape == SCENE_CLOAK) {
        scene_cloak_point(scene, uvw, xyz);
        return;
    }
    if (pattern_starts_in_space(scene->pattern)) {
        begin_in_space(scene, uvw, xyz);
        return;
    }
    const struct scene_pose *pose = &scene->pose[scene_sheet_at(scene, uvw[0], &s)];
    vector_cross(pose->axis_u, pose->axis_v, e_w);
    for (int i = 0; i < 3; i++)
        xyz[i] = pose->origin[i] + s * scene->length * pose->axis_u[i] +
                 uvw[1] * scene->width * pose->axis_v[i] +
                 (uvw[2] - 0.5) * scene->thickness * e_w[i];
}

void scene_initial_velocity(const struct scene *scene, const double xyz[3], double v[3])
{
    const double *spin = scene->spin;
    const double ripple = scene_ripples(scene) ? scene_ripple(scene, xyz) : 0;

    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        v[i] = scene->velocity[i] + spin[j] * xyz[k] - spin[k] * xyz[j];
        if (ripple != 0)
            v[i] += ripple * scene->ripple[i];
    }
}

bool scene_is_cantilever(const struct scene *scene)
{
    const struct scene_support *s = scene->supports;

    return scene->sheets < 2 && !scene->pattern && scene->support_count == 1 &&
           s->lo[0] == 0 && s->hi[0] == 0 && s->lo[1] == 0 && s->hi[1] == 1 &&
           s->lo[2] == 0 && s->hi[2] == 1 && s->fix == FIX_XYZ && !SCENE_MOVES(s->motion) &&
           !scene_grips(s);
}

bool scene_edge_clamped(const struct scene *scene, int sheet, int i, bool end)
{
    double from[3] = {scene_sheet_u(scene, sheet, 0), 0, 0};
    double to[3] = {scene_sheet_u(scene, sheet, 1), 1, 1};

    if (end)
        from[i] = to[i];
    else
        to[i] = from[i];
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        bool whole = s->fix == FIX_XYZ && !scene_grips(s);
        for (int k = 0; k < 3; k++)
            whole = whole && s->lo[k] <= from[k] && s->hi[k] >= to[k];
        if (whole)
            return true;
    }
    return false;
}

double scene_wind_speed(const struct scene *s)
{
    double most = s->drag > 0 ? vector_length(s->wind) : 0;

    for (int n = 0; n < s->air.wind_count; n++)
        most = fmax(most, vector_length(s->air.wind[n] + 1));
    return most;
}

bool scene_same_across(const struct scene *s)
{
    bool same = s->shape == SCENE_FLAT && !s->pattern && !s->is_fabric &&
                !s->obstacle_count && !scene_ripples(s) &&
                vector_dot(s->gravity, s->axis_v) == 0 &&
                vector_dot(s->wind, s->axis_v) == 0 &&
                vector_dot(s->velocity, s->axis_v) == 0 && vector_length(s->spin) == 0;

    for (int n = 0; n < s->support_count; n++) {
        const struct scene_motion *m = &s->supports[n].motion;
        same &= s->supports[n].lo[1] <= 0 && s->supports[n].hi[1] >= 1 && !m->turn_count;
        for (int k = 0; k < m->path_count; k++)
            same &= vector_dot(m->path[k] + 1, s->axis_v) == 0;
    }
    for (int n = 0; n < s->air.wind_count; n++)
        same &= vector_dot(s->air.wind[n] + 1, s->axis_v) == 0;
    for (int n = 0; n < s->load_count; n++)
        same &= s->loads[n].lo[1] <= 0 && s->loads[n].hi[1] >= 1 &&
                vector_dot(s->loads[n].force, s->axis_v) == 0;
    return same;
}

struct law scene_law(const struct scene *scene)
{
    return scene->is_fabric ? law_of_fabric(&scene->fabric)
                            : law_isotropic(scene->young, scene->poisson, scene->thickness);
}

void scene_use_fabric(struct scene *scene)
{
    const struct law law = law_of_fabric(&scene->fabric);

    scene->is_fabric = true;
    scene->young = law.young, scene->poisson = law.poisson;
    scene->thickness = law.thickness;
    scene->density = scene->fabric.areal_density / law.thickness;
}

double scene_bending_stiffness(const struct scene *scene)
{
    return scene_law(scene).matrix[LAW_BENDING][LAW_11];
}

double scene_gamma(const struct scene *scene)
{
    const double L = scene->length; /* weight [N/m^2] */
    const double weight = scene->density * vector_length(scene->gravity) * scene->thickness;

    return weight * L * L * L / scene_bending_stiffness(scene);
}
