/* scene_check.c - checks values of a scene that must fit together. */
#include "models/reader/scene_check.h"
#include "models/damping.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "models/contact/contact_law.h"
#include "models/contact/contact_rest.h"
#include "models/discretization.h"
#include "models/reader/mesh_file.h"
#include "models/reader/scene_material.h"
#include "models/vector.h"

/* Axes written with four digits or more are meant as orthonormal, and the reader makes them
 * so; what is farther off is a mistake. */
#define TOL_AXES 1e-3
/* Axes written with ten digits stay: stored results are found by a scene's numbers. */
#define TOL_EXACT 1e-9
/* The round-off of two ways to write the same path, relative to the shift. */
#define TOL_PATH 1e-12

/* [m] */
#define LEAST_RANGE 1e-10

static bool is_setting(const struct yaml_tree *node)
{
    return node->line == 0;
}

/* Makes an axis that is nearly of length one exactly so. */
static enum status check_axis(const struct yaml_tree *node, const char *owner,
                              double axis[3], struct message *why)
{
    const double length = vector_length(axis);
    const char *name = node ? node->key : "";

    if (!node)
        return STATUS_OK;
    if (length == 0)
        return yaml_tree_refuse(node, why, "%s axis %s is zero, but must have length 1",
                                owner, name);
    if (fabs(length - 1) > TOL_AXES)
        return yaml_tree_refuse(node, why,
                                "%s axis %s has length %.10g, but must have length 1, "
                                "as [%.10g, %.10g, %.10g] has",
                                owner, name, length, axis[0] / length, axis[1] / length,
                                axis[2] / length);
    for (int i = 0; i < 3 && fabs(length - 1) > TOL_EXACT; i++)
        axis[i] /= length;
    return STATUS_OK;
}

/* Checks a number of a section (damping, pose), which its `kind` takes or does not. */
static enum status check_taken(const struct yaml_tree *section, const char *kind_name,
                               const char *name, bool taken, double *number,
                               struct message *why)
{
    const struct yaml_tree *node = yaml_tree_find(section, name);
    const struct yaml_tree *kind = yaml_tree_find(section, "kind");

    if (!node || taken)
        return STATUS_OK;
    if (!kind || !is_setting(kind) || is_setting(node))
        return yaml_tree_refuse(node, why, "%s of kind '%s' takes no '%s'; leave it out",
                                section->key, kind_name, name);
    *number = 0;
    return STATUS_OK;
}

/* Refuses a cloak whose inner face reaches its axis, at either end. */
static enum status check_radius(const struct yaml_tree *root, const struct scene *scene,
                                struct message *why)
{
    const char *const end[2] = {"upper edge", "hem"};

    for (int u = 0; u < 2; u++) {
        double r, z;

        scene_cloak_meridian(scene, u, 0, &r, &z);
        if (!(r > 0))
            return yaml_tree_refuse(
                yaml_tree_find(root, "pose"), why,
                "the cloak's %s has an inner radius of %.4g m, but must "
                "stay clear of the axis: it needs more width, less "
                "opening, or another flare",
                end[u], r);
    }
    return STATUS_OK;
}

static enum status check_shape(const struct yaml_tree *root, struct scene *scene,
                               struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *pose = yaml_tree_find(root, "pose");
    const bool cloak = scene->shape == SCENE_CLOAK;
    const char *kind = scene_shape_words[scene->shape];

    if (!pose)
        return STATUS_OK;
    TRY(check_taken(pose, kind, "opening", cloak, &scene->opening, why));
    TRY(check_taken(pose, kind, "flare", cloak, &scene->flare, why));
    if (cloak && !yaml_tree_find(pose, "opening"))
        return yaml_tree_refuse(pose, why, "pose of kind 'cloak' lacks the key 'opening'");
    if (cloak && scene->opening > SCENE_CLOAK_MAX_OPENING && !scene_closed(scene))
        return yaml_tree_refuse(yaml_tree_find(pose, "opening"), why,
                                "opening is %g, but must be at most %d degrees, or 360 for "
                                "a cloak that is closed",
                                scene->opening, SCENE_CLOAK_MAX_OPENING);
    if (cloak)
        TRY(check_radius(root, scene, why));
out:
    return st;
}

/* Refuses loads on a curved shape, where even over parameters is not even over area, and
 * pressure on a sheet with sides, which has no potential unless they are held. */
static enum status check_loads(const struct yaml_tree *root, const struct scene *scene,
                               struct message *why)
{
    if (scene->load_count && scene->shape != SCENE_FLAT)
        return yaml_tree_refuse(yaml_tree_find(root, "loads"), why,
                                "loads are for flat sheets, but pose has kind '%s'",
                                scene_shape_words[scene->shape]);
    if (scene->pressure != 0 && !scene_closed(scene))
        return yaml_tree_refuse(yaml_tree_find(root, "pressure"), why,
                                "pressure is for a closed sheet: pose must have kind "
                                "'cloak' and opening 360");
    return STATUS_OK;
}

/* Removes u's component from v, and makes its length one. */
static void turn_upright(const double u[3], double cosine, double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] -= cosine * u[i];
    const double length = vector_length(v);
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

/* Checks the axes u and v of a section, `owner` in sentences, and makes them orthonormal.
 */
static enum status check_axes(const struct yaml_tree *section, const char *owner,
                              double axis_u[3], double axis_v[3], struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *u = yaml_tree_find(section, "u");
    const struct yaml_tree *v = yaml_tree_find(section, "v");

    TRY(check_axis(u, owner, axis_u, why));
    TRY(check_axis(v, owner, axis_v, why));
    const double cosine = vector_dot(axis_u, axis_v);
    if (fabs(cosine) > TOL_AXES)
        return yaml_tree_refuse(v ? v : u, why,
                                "%s axes u and v have the product %.10g, but must be at "
                                "right angles",
                                owner, cosine);
    if (fabs(cosine) > TOL_EXACT)
        turn_upright(axis_u, cosine, axis_v);
out:
    return st;
}

/* Checks the places and materials of several sheets, which meet unless the scene says
 * otherwise. */
static enum status check_sheets(const struct yaml_tree *root, struct scene *scene,
                                struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *list = yaml_tree_find(root, "sheets");
    const struct yaml_tree *pose = yaml_tree_find(root, "pose");
    const struct yaml_tree *row = yaml_tree_first(root, "sheets");

    if (list && pose)
        return yaml_tree_refuse(is_setting(list) ? list : pose, why,
                                "the scene has both pose and sheets, but must have one: "
                                "the rows of sheets say where each lies");
    for (struct scene_pose *p = scene->pose; row; p++, row = row->next) {
        const struct yaml_tree *material = yaml_tree_find(row, "material");
        TRY(check_axes(row, "sheet", p->axis_u, p->axis_v, why));
        if (material && (scene->is_fabric || scene->fabric_mean))
            return yaml_tree_refuse(material, why, SCENE_MATERIAL_OWN);
        if (material && scene->drag > 0)
            return yaml_tree_refuse(material, why,
                                    "body drag is for sheets of one material; leave out "
                                    "drag, or the sheet's own material");
    }
    if (list && !yaml_tree_find(root, "contact"))
        scene->contact.self = true;
out:
    return st;
}

/* Turns the range of u along a sheet, where a support or load has one, into that of the
 * scene. */
static enum status check_place(const struct scene *scene, const struct yaml_tree *node,
                               int sheet, double *lo, double *hi, struct message *why)
{
    const struct yaml_tree *at = yaml_tree_find(node, "at"), *u = yaml_tree_find(at, "u");

    if (sheet > 1 && sheet > scene->sheets)
        return yaml_tree_refuse(yaml_tree_find(at, "sheet"), why,
                                "sheet is %d, but the scene has %d", sheet, scene->sheets);
    if (u && !sheet && scene->sheets > 1)
        return yaml_tree_refuse(u, why,
                                "the scene has %d sheets, and u runs along one: it must be "
                                "named, as in {sheet: 1, u: 0}",
                                scene->sheets);
    if (sheet) {
        *lo = scene_sheet_u(scene, sheet - 1, *lo);
        *hi = scene_sheet_u(scene, sheet - 1, *hi);
    }
    return STATUS_OK;
}

static enum status check_places(const struct yaml_tree *root, struct scene *scene,
                                struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *node = yaml_tree_first(root, "supports");

    for (struct scene_support *s = scene->supports; node; s++, node = node->next)
        TRY(check_place(scene, node, s->sheet, &s->lo[0], &s->hi[0], why));
    node = yaml_tree_first(root, "loads");
    for (struct scene_load *l = scene->loads; node; l++, node = node->next)
        TRY(check_place(scene, node, l->sheet, &l->lo[0], &l->hi[0], why));
out:
    return st;
}

static enum status check_damping(const struct yaml_tree *root, struct scene *scene,
                                 struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *damping = yaml_tree_find(root, "damping"), *value;
    struct scene_damping *d = &scene->damping;
    const bool rayleigh = d->kind == DAMPING_RAYLEIGH;
    const char *kind = damping_words[d->kind];
    const bool one_value = d->kind != DAMPING_NONE && !rayleigh;

    if (!damping)
        return STATUS_OK;
    TRY(check_taken(damping, kind, "value", one_value, &d->value, why));
    TRY(check_taken(damping, kind, "alpha", rayleigh, &d->alpha, why));
    TRY(check_taken(damping, kind, "beta", rayleigh, &d->beta, why));
    value = yaml_tree_find(damping, "value");
    if (one_value && !value)
        return yaml_tree_refuse(damping, why, "damping of kind '%s' lacks the key 'value'",
                                damping_words[d->kind]);
    if (rayleigh && !yaml_tree_find(damping, "alpha") && !yaml_tree_find(damping, "beta"))
        return yaml_tree_refuse(damping, why,
                                "damping of kind 'rayleigh' lacks the key 'alpha' "
                                "or 'beta'");
    if (d->kind == DAMPING_VELOCITY_SCALE && d->value > 1)
        return yaml_tree_refuse(value, why,
                                "velocity_scale %g would speed the sheet up; it must "
                                "be from 0 to 1",
                                d->value);
    if (d->kind == DAMPING_VELOCITY_RATE && d->value * scene->step > 1)
        return yaml_tree_refuse(value, why,
                                "velocity_rate %g turns velocities round in each "
                                "step of %g s; it must be %g at most",
                                d->value, scene->step, 1 / scene->step);
out:
    return st;
}

static enum status check_time(const struct yaml_tree *root, const struct scene *scene,
                              struct message *why)
{
    const struct yaml_tree *time = yaml_tree_find(root, "time");
    const struct yaml_tree *step = yaml_tree_find(time, "step");
    const struct yaml_tree *end = yaml_tree_find(time, "end");
    const struct yaml_tree *blame = is_setting(step) && !is_setting(end) ? step : end;

    if (scene->end < scene->step)
        return yaml_tree_refuse(blame, why,
                                "end %g s comes before the first step of %g s; it "
                                "must be as long at least",
                                scene->end, scene->step);
    if (scene->end / scene->step > SCENE_MAX_FRAMES)
        return yaml_tree_refuse(blame, why, "%.3g steps of %g s, but must be %d at most",
                                scene->end / scene->step, scene->step, SCENE_MAX_FRAMES);
    return STATUS_OK;
}

static enum status check_ripple(const struct yaml_tree *root, const struct scene *scene,
                                struct message *why)
{
    const struct yaml_tree *motion = yaml_tree_find(root, "motion");

    if (scene_ripples(scene) && scene->wave == 0)
        return yaml_tree_refuse(yaml_tree_find(motion, "ripple"), why,
                                "ripple needs the key 'wave', the length of its waves [m]");
    return STATUS_OK;
}

static enum status check_snapshots(const struct yaml_tree *root, struct scene *scene,
                                   struct message *why)
{
    const struct yaml_tree *list = yaml_tree_find(root, "snapshots"), *node;
    const struct yaml_tree *end = yaml_tree_find(yaml_tree_find(root, "time"), "end");
    int kept = 0;

    if (!list)
        return STATUS_OK;
    for (node = list->first; node && scene->snapshots[kept] <= scene->end;
         node = node->next)
        kept++;
    if (node && (!is_setting(end) || is_setting(node)))
        return yaml_tree_refuse(node, why, "snapshot %g s comes after the end at %g s",
                                scene->snapshots[kept], scene->end);
    scene->snapshot_count = kept;
    return STATUS_OK;
}

/* Tells whether closed boxes have a point in common. */
static bool overlap(const struct scene_support *a, const struct scene_support *b)
{
    for (int i = 0; i < 3; i++)
        if (a->hi[i] < b->lo[i] || b->hi[i] < a->lo[i])
            return false;
    return true;
}

static bool same(double a, double b)
{
    return fabs(a - b) <= TOL_PATH * (1 + fabs(a));
}

/* Tells whether motions agree at every row of `a`, displacements in the components `fix`.
 */
static bool agrees_at_rows(const struct scene_motion *a, const struct scene_motion *b,
                           unsigned fix)
{
    bool agree = true;

    for (int k = 0; k < a->path_count; k++) {
        double of_b[3];

        scene_motion_table(b->path_count, 4, (const double *)b->path, a->path[k][0], of_b);
        for (int i = 0; i < 3; i++)
            agree = agree && (!(fix & 1u << i) || same(a->path[k][i + 1], of_b[i]));
    }
    for (int k = 0; k < a->turn_count; k++) {
        double of_b;

        scene_motion_table(b->turn_count, 2, (const double *)b->turn, a->turn[k][0], &of_b);
        agree = agree && same(a->turn[k][1], of_b);
    }
    for (int i = 0; a->turn_count && i < 3; i++)
        agree = agree && same(a->axis[i], b->axis[i]) && same(a->about[i], b->about[i]);
    return agree;
}

/* Compares all pairs, O(supports^2 rows log rows): piecewise linear motions are equal if
 * they are so at all rows. */
static enum status check_supports(const struct yaml_tree *root, const struct scene *scene,
                                  struct message *why)
{
    const struct yaml_tree *node = yaml_tree_first(root, "supports");

    for (int j = 0; node; j++, node = node->next)
        for (int i = 0; i < j; i++) {
            const struct scene_support *a = &scene->supports[i], *b = &scene->supports[j];
            const unsigned fix = a->fix & b->fix;

            if (fix && overlap(a, b) &&
                !(agrees_at_rows(&a->motion, &b->motion, fix) &&
                  agrees_at_rows(&b->motion, &a->motion, fix)))
                return yaml_tree_refuse(
                    node, why,
                    "supports[%d] contradicts supports[%d]: they "
                    "hold the same points in the same component, but move "
                    "differently",
                    j, i);
        }
    return STATUS_OK;
}

static enum status check_contact(const struct yaml_tree *root, const struct scene *scene,
                                 struct message *why)
{
    const struct yaml_tree *section = yaml_tree_find(root, "contact");
    const struct yaml_tree *range = yaml_tree_find(section, "range");
    const struct contact_law law = contact_law_self(scene);

    if (section && (law.range >= law.start || law.range < LEAST_RANGE))
        return yaml_tree_refuse(range ? range : section, why,
                                "contact has a range of %g m, but it must be %g m at least "
                                "and less than its thickness of %g m, where contact starts",
                                law.range, LEAST_RANGE, law.start);
    return STATUS_OK;
}

/* Reads the mesh that an obstacle names, if `files`; `section` is its own. */
static enum status load_mesh(const struct yaml_tree *root, const struct yaml_tree *section,
                             bool files, struct scene_obstacle *o, struct message *why)
{
    const struct yaml_tree *file = yaml_tree_find(section, "file");
    const char *slash = *o->file == '/' ? NULL : strrchr(root->origin, '/');
    const int folder = slash ? (int)(slash - root->origin) + 1 : 0;
    const size_t length = strlen(o->file);
    struct message inner = {""};
    char path[4096];

    if (length < 5 || strcmp(o->file + length - 4, ".obj") != 0)
        return yaml_tree_refuse(file, why,
                                "file is %s, but must name an OBJ file, as body.obj",
                                yaml_tree_quote(o->file).text);
    if (!files)
        return STATUS_OK;
    if (snprintf(path, sizeof path, "%.*s%s", folder, root->origin, o->file) >=
        (int)sizeof path)
        return yaml_tree_refuse(file, why, "the path of the mesh is too long");
    const enum status st = mesh_file_read(path, o->point, o->scale, &o->mesh, &inner);
    return st == STATUS_INPUT ? yaml_tree_refuse(file, why, "%s", inner.text) : st;
}

static enum status check_obstacles(const struct yaml_tree *root, bool files,
                                   struct scene *scene, struct message *why)
{
    enum status st = STATUS_OK;
    const struct yaml_tree *node = yaml_tree_first(root, "obstacles");

    for (int n = 0; node; n++, node = node->next) {
        struct scene_obstacle *o = &scene->obstacles[n];
        if (o->kind == OBSTACLE_BOX)
            TRY(check_axes(yaml_tree_find(node, "box"), "box", o->axis[0], o->axis[1],
                           why));
        if (o->kind == OBSTACLE_MESH)
            TRY(load_mesh(root, yaml_tree_find(node, "mesh"), files, o, why));
        const double depth = contact_rest_depth(scene, o);
        if (depth > 0)
            return yaml_tree_refuse(
                node, why, CONTACT_REST_DEPTH ", but must stay clear of it", depth, n);
    }
out:
    return st;
}

static enum status check_stack(const struct yaml_tree *root, const struct scene *scene,
                               struct message *why)
{
    const struct yaml_tree *row = yaml_tree_first(root, "sheets");

    for (int k = 0, before; row; k++, row = row->next) {
        const double overlap = contact_rest_overlap(scene, k, &before);
        if (overlap > 0)
            return yaml_tree_refuse(row, why, CONTACT_REST_OVERLAP, k + 1, overlap,
                                    before + 1);
    }
    return STATUS_OK;
}

enum status scene_check(const struct yaml_tree *root, bool files, struct scene *scene,
                        struct message *why)
{
    enum status st = STATUS_OK;

    TRY(scene_material_thickness(root, scene, why));
    TRY(check_sheets(root, scene, why));
    TRY(check_axes(yaml_tree_find(root, "pose"), "pose", scene->axis_u, scene->axis_v,
                   why));
    TRY(check_shape(root, scene, why));
    TRY(check_places(root, scene, why));
    TRY(check_time(root, scene, why));
    TRY(check_damping(root, scene, why));
    TRY(check_ripple(root, scene, why));
    TRY(check_snapshots(root, scene, why));
    TRY(check_supports(root, scene, why));
    TRY(check_loads(root, scene, why));
    TRY(check_contact(root, scene, why));
    TRY(check_obstacles(root, files, scene, why));
    TRY(check_stack(root, scene, why));
out:
    return st;
}
