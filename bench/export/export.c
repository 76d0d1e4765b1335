#include "bench/ui/command.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/export/export_parts.h"
#include "bench/files/folder.h"
#include "models/damping.h"
#include "models/reader/scene_file.h"
#include "models/reader/scene_schema.h"

#define MESH_FILE "obstacle_%d.obj"

/* --- scene.yaml: what was set is in it, and what its truth changes; comments are not ---
 */

/* Prints a text in which each # stands for the next number, with as many digits as it takes
 * to read it again; never -0. */
static void put(struct output *out, const char *text, const double *value)
{
    for (; *text; text++)
        if (*text != '#')
            output_print(out, "%c", *text);
        else
            output_print(out, "%.*g", output_digits(*value), *value + 0.0), value++;
}

static void put_text(struct output *out, const char *key, const char *text)
{
    output_print(out, "%s: \"", key);
    for (; *text; text++)
        output_print(out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    output_print(out, "\"\n");
}

static void put_fabric(const struct law_fabric *f, struct output *out)
{
    put(out, "material:\n  membrane: [#, #, #, #]\n", f->membrane);
    put(out, "  bending: [#, #, #, #]\n", f->bending);
    put(out, "  areal_density: #\n", &f->areal_density);
    put(out, "  warp: #\n", &f->warp);
    if (f->softening[0] != 0 || f->softening[1] != 0)
        put(out, "  softening: [#, #]\n", f->softening);
}

static void put_sheet(const struct scene *s, struct output *out)
{
    put(out,
        s->is_fabric ? "sheet: {length: #, width: #}\n"
                     : "sheet: {length: #, width: #, thickness: #}\n",
        (double[]){s->length, s->width, s->thickness});
    if (s->sheets < 2)
        output_print(out, "pose:\n  kind: %s\n", scene_shape_words[s->shape]);
    for (int k = 0; k < scene_sheets(s); k++) {
        const char *head = s->sheets < 2 ? "  " : k ? "  - " : "sheets:\n  - ";
        output_print(out, "%s", head);
        put(out, "origin: [#, #, #]\n", s->pose[k].origin);
        put(out, s->sheets < 2 ? "  u: [#, #, #]\n" : "    u: [#, #, #]\n",
            s->pose[k].axis_u);
        put(out, s->sheets < 2 ? "  v: [#, #, #]\n" : "    v: [#, #, #]\n",
            s->pose[k].axis_v);
    }
    if (s->shape == SCENE_CLOAK)
        put(out, "  opening: #\n  flare: #\n", (double[]){s->opening, s->flare});
    if (s->is_fabric)
        put_fabric(&s->fabric, out);
    else
        put(out, "material: {young: #, poisson: #, density: #}\n",
            (double[]){s->young, s->poisson, s->density});
}

static void put_forces(const struct scene *s, struct output *out)
{
    const struct scene_damping *d = &s->damping;

    put(out, "gravity: [#, #, #]\n", s->gravity);
    if (s->pressure != 0)
        put(out, "pressure: #\n", &s->pressure);
    if (s->drag > 0) {
        put(out, "drag: {coefficient: #", &s->drag);
        put(out, ", wind: [#, #, #]}\n", s->wind);
    }
    output_print(out, "damping: {kind: %s", damping_words[d->kind]);
    if (d->kind == DAMPING_RAYLEIGH)
        put(out, ", alpha: #, beta: #", (double[]){d->alpha, d->beta});
    else if (d->kind != DAMPING_NONE)
        put(out, ", value: #", &d->value);
    output_print(out, "}\n");
    if (scene_needs(s) & SCENE_NEED_INITIAL_MOTION) {
        put(out, "motion: {velocity: [#, #, #]", s->velocity);
        put(out, ", spin: [#, #, #]", s->spin);
        if (scene_ripples(s)) {
            put(out, ", ripple: [#, #, #]", s->ripple);
            put(out, ", wave: #", &s->wave);
            output_print(out, ", seed: %d", s->seed);
        }
        output_print(out, "}\n");
    }
}

/* Begins an element of a list; of several sheets u is that along the one that it names, or
 * all of it. */
static void put_region(const struct scene *s, int sheet, struct output *out,
                       const double lo[3], const double hi[3])
{
    output_print(out, "  - at: {");
    if (s->sheets > 1 && sheet)
        output_print(out, "sheet: %d, ", sheet);
    for (int c = s->sheets > 1 && !sheet; c < 3; c++) {
        double at[2] = {lo[c], hi[c]};
        for (int k = 0; c == 0 && k < 2 && s->sheets > 1; k++) {
            scene_sheet_at(s, at[k], &at[k]);
            at[k] = nearbyint(at[k] * 1e12) / 1e12; /* as it was typed */
        }
        output_print(out, "%c: ", "uvw"[c]);
        put(out, at[0] == at[1] ? "#" : "[#, #]", at);
        output_print(out, c < 2 ? ", " : "}\n");
    }
}

static void put_motion(const struct scene_motion *m, struct output *out)
{
    output_print(out, "%s", m->path_count ? "    path:\n" : "");
    for (int k = 0; k < m->path_count; k++)
        put(out, "      - [#, #, #, #]\n", m->path[k]);
    if (!m->turn_count)
        return;
    put(out, "    turn:\n      axis: [#, #, #]\n", m->axis);
    put(out, "      about: [#, #, #]\n      angles:\n", m->about);
    for (int k = 0; k < m->turn_count; k++)
        put(out, "        - [#, #]\n", m->turn[k]);
}

static void put_supports(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->support_count; n++) {
        const struct scene_support *p = &s->supports[n];
        output_print(out, "%s", n ? "" : "supports:\n");
        put_region(s, p->sheet, out, p->lo, p->hi);
        output_print(out, "    fix: %s\n", export_sheet_axes(p->fix));
        put_motion(&p->motion, out);
    }
    for (int n = 0; n < s->load_count; n++) {
        output_print(out, "%s", n ? "" : "loads:\n");
        put_region(s, s->loads[n].sheet, out, s->loads[n].lo, s->loads[n].hi);
        put(out, "    force: [#, #, #]\n", s->loads[n].force);
    }
}

/* Puts the numbers of each kind; a mesh lies in a file of its own, where it is. */
static void put_obstacles(const struct scene *s, struct output *out)
{
    for (int n = 0; n < s->obstacle_count; n++) {
        const struct scene_obstacle *o = &s->obstacles[n];
        const struct schema_key *kind = &scene_schema_obstacles[o->kind];
        output_print(out, "%s  - %s:\n", n ? "" : "obstacles:\n", kind->key);
        if (o->kind == OBSTACLE_MESH) {
            output_print(out, "      file: " MESH_FILE "\n", n);
            put(out, "      friction: #\n", &o->friction);
        }
        for (const struct schema_key *k = kind->keys; o->kind != OBSTACLE_MESH && k->key;
             k++) {
            const bool vector = k->type == SCHEMA_VECTOR;
            if (!vector && k->type != SCHEMA_NUMBER)
                continue;
            output_print(out, "      %s: ", k->key);
            put(out, vector ? "[#, #, #]\n" : "#\n",
                (const void *)((const char *)o + k->offset));
        }
        put_motion(&o->motion, out);
    }
}

static void put_contact(const struct scene *s, struct output *out)
{
    const struct scene_contact *c = &s->contact;

    if (!c->self && c->thickness == 0 && c->range == 0 && c->stiffness == 0 &&
        c->friction == 0)
        return;
    output_print(out, "contact: {self: %s", c->self ? "true" : "false");
    put(out, ", thickness: #, range: #, stiffness: #, friction: #}\n",
        (double[]){c->thickness, c->range, c->stiffness, c->friction});
}

static enum status write_scene(struct export_job *j, struct output *out)
{
    const struct scene *scene = &j->scene;

    output_print(out, "name: %s\n", scene->name);
    put_text(out, "source", scene->source);
    put_sheet(scene, out);
    put_forces(scene, out);
    put_supports(scene, out);
    put_obstacles(scene, out);
    put_contact(scene, out);
    put(out, "time: {step: #, end: #}\n", (double[]){scene->step, scene->end});
    for (int n = 0; n < scene->snapshot_count; n++)
        put(out, n ? ", #" : "snapshots: [#", &scene->snapshots[n]);
    output_print(out, "%s", scene->snapshot_count ? "]\n" : "");
    return STATUS_OK;
}

/* --- README.md: the rules on one page --- */

/* Puts three corners of a sheet at rest. */
static void put_corners(const struct scene *c, int sheet, struct output *out)
{
    for (int n = 0; n < 3; n++) {
        const double corner[3] = {scene_sheet_u(c, sheet, n == 1), n == 2, 0.5};
        double x[3];
        scene_rest_point(c, corner, x);
        output_print(out, "%s u = %.6g, v = %g is at (%.4g, %.4g, %.4g)",
                     n       ? ","
                     : sheet ? "\nOf the next sheet"
                             : " At rest",
                     corner[0], corner[1], x[0] + 0.0, x[1] + 0.0, x[2] + 0.0);
    }
    output_print(out, ".");
}

static void put_title(const struct export_job *j, struct output *out)
{
    const struct scene *c = &j->scene;
    const int *points = j->sheet.points;
    const double *g = c->gravity;
    char number[16] = "A";

    if (c->sheets > 1)
        snprintf(number, sizeof number, "%d", c->sheets);

    output_print(out, "# %s for your simulator\n\n%s %s sheet%s %g m (u) by %g m (v), ",
                 c->name, number, scene_shape_words[c->shape],
                 c->sheets > 1 ? "s, each" : ",", c->length, c->width);
    if (c->is_fabric)
        output_print(out, "a fabric of %g kg/m^2, h_eff = %g m", c->fabric.areal_density,
                     c->thickness);
    else
        output_print(out, "%g m thick: E = %g Pa, nu = %g, rho = %g kg/m^3", c->thickness,
                     c->young, c->poisson, c->density);
    output_print(out,
                 "; gravity\n%g %g %g m/s^2; Gamma = rho g h L^3 / D = %.4g.\nSource: "
                 "%s.\n\n",
                 g[0] + 0.0, g[1] + 0.0, g[2] + 0.0, scene_gamma(c), c->source);
    output_print(out, "SI units; x, y, z right-handed.");
    for (int k = 0; k < scene_sheets(c); k++)
        put_corners(c, k, out);
    if (c->sheets > 1)
        output_print(
            out,
            "\nVertex j %d + (k - 1) %d + i is point (i/%d, j/%d) of sheet k, 1 to "
            "%d: a row goes through all\nsheets, and nothing connects them. u counts "
            "on from sheet to sheet, as the files have it.",
            export_sheet_columns(&j->sheet), points[0], points[0] - 1, points[1] - 1,
            c->sheets);
    else
        output_print(out, "\nVertex j %d + i is at u = i/%d, v = j/%d.", points[0],
                     points[0] - 1, points[1] - 1);
    output_print(
        out, " Files count vertices from 0, "
             "OBJ from 1.\nTriangles are counter-clockwise seen from u x v; the diagonals "
             "alternate.\n\n");
}

static void put_damping(const struct scene *c, bool undamped, bool at_rest,
                        struct output *out)
{
    const struct scene_damping *d = &c->damping;

    if (at_rest)
        output_print(out, "- Damping: any, as long as the sheet is at rest at the end. The "
                          "truth is the shape at rest.\n");
    else if (undamped)
        output_print(out, "- No damping: the scene scales velocities by a factor a step, "
                          "which is no rate; its truth is undamped.\n");
    else if (d->kind == DAMPING_NONE)
        output_print(out, "- No damping, no drag of the air but what is said here.\n");
    else if (d->kind == DAMPING_RAYLEIGH)
        output_print(out,
                     "- Damping %g M + %g s K: forces against velocity by mass and "
                     "stiffness.\n",
                     d->alpha, d->beta);
    else
        output_print(out,
                     "- Damping: a force of %g 1/s times mass against the velocity of "
                     "each point.\n",
                     d->value);
}

/* Tells whether obstacles.csv says all there is to the obstacles. */
static bool in_table(const struct scene *c)
{
    bool all = !(scene_needs(c) & SCENE_NEED_MOVING_OBSTACLES);

    for (int n = 0; n < c->obstacle_count; n++)
        all = all && (c->obstacles[n].kind == OBSTACLE_PLANE ||
                      c->obstacles[n].kind == OBSTACLE_SPHERE);
    return all;
}

static void put_physics(const struct export_job *j, struct output *out)
{
    const struct scene *c = &j->scene;
    const unsigned needs = scene_needs(c);

    output_print(out, "## Physics of the truth\n\n");
    put_damping(c, j->undamped, j->known.closed && c->support_count, out);
    output_print(out,
                 "- From t = 0 at rest in the rest shape%s, without stress; large "
                 "displacements; %s.\n",
                 needs & SCENE_NEED_INITIAL_MOTION ? " but for velocities.csv [m/s]" : "",
                 !(needs & SCENE_NEED_SELF_CONTACT) ? "no self-contact"
                 : needs & SCENE_NEED_SHEETS
                     ? "the sheets meet each other and themselves (scene.yaml)"
                     : "the sheet meets itself (scene.yaml)");
    if (needs & SCENE_NEED_DRAG)
        output_print(out,
                     "- Body drag: %g kg/m^3/s times (wind - velocity) per volume, wind "
                     "%g %g %g m/s: times area and h per vertex.\n",
                     c->drag, c->wind[0], c->wind[1], c->wind[2]);
    if (needs & SCENE_NEED_PRESSURE)
        output_print(out,
                     "- Pressure of %g Pa against the outward normal, as it turns: times a "
                     "vertex's area.\n",
                     c->pressure);
    if (needs & SCENE_NEED_CONTACT)
        output_print(out,
                     "- Obstacles%s: obstacles.csv; normals point outward; "
                     "Coulomb friction. The sheet's faces, h/2 off its middle, touch.\n",
                     needs & SCENE_NEED_MOVING_OBSTACLES ? "" : " stand still");
    if (needs & SCENE_NEED_CONTACT && !in_table(c))
        output_print(
            out, "  obstacles.csv has all there is to a `plane` or `sphere`; the rest of "
                 "a `capsule`, `box` or `mesh`\n  (obstacle_N.obj) and of one that moves "
                 "(`moving_...`, its place without the motion) is in scene.yaml.\n");
    if (needs & SCENE_NEED_LOADS)
        output_print(out,
                     "- Forces that keep their direction from t = 0: loads.csv [N].\n");
    if (needs & SCENE_NEED_MOVING_SUPPORTS)
        output_print(out, "- Held vertices with a `path` move: rest + paths.csv [s, m], "
                          "linear between rows, constant outside.\n");
    output_print(out, "\n");
}

static void put_held(const struct export_held *h, struct output *out)
{
    output_print(out, "## What is held\n\n");
    if (!h->count) {
        output_print(out, "Nothing.\n\n");
        return;
    }
    output_print(out, "held.csv: %d vertices of the sheet, in the components `fix`.",
                 h->count - h->outside);
    if (h->outside)
        output_print(
            out,
            "\nIts last %d rows, with `beside`, are vertices outside the sheet, one cell "
            "off "
            "the vertex beside.\nWhere bending is an angle between elements, a held row "
            "alone "
            "is a hinge: add these, held\nlikewise, and elements between them and the held "
            "row, without mass; leave them out of your\nframes. The angle over the held "
            "row "
            "stands for half a cell of the sheet: its stiffness is doubled\n(Parameters). "
            "A "
            "simulator with rotations holds those of the held vertices instead and needs "
            "none.",
            h->outside);
    else
        output_print(out, " No row outside the sheet is needed.");
    output_print(out, "%s%s\n\n", *h->doubt.text ? "\nNote: " : "", h->doubt.text);
}

/* Says what a simulator without softening loses of it. */
static void put_softening(const struct export_job *j, struct output *out)
{
    const struct law law = scene_law(&j->scene);
    const double *B = j->scene.fabric.bending;
    static const char *const name[] = {"warp", "weft"};

    for (int n = 0; n < 2; n++)
        if (law.soft[n].second < 0)
            output_print(out,
                         "- bending along the %s softens: M = B%d k + C%d k |k| up to k = "
                         "%.3g 1/m. Without C%d [N m^2],\n  which only a curve of moment "
                         "over curvature holds, a sheet is %.3g times as stiff there;\n",
                         name[n], n + 1, n + 1, law.soft[n].most, n + 1,
                         B[n] / (B[n] + law.soft[n].second * law.soft[n].most));
}

/* Says what each kind of simulator takes of a fabric, and what is lost on the way. */
static void put_fabric_parameters(const struct export_job *j, struct output *out)
{
    const struct law_fabric *f = &j->scene.fabric;
    const double *Y = f->membrane, *B = f->bending;
    struct law law = scene_law(&j->scene);

    output_print(
        out,
        "## Parameters\n\n"
        "materials.csv. They follow from the fabric's moduli by rule; none is fitted.\n"
        "The warp runs at %g degrees from u towards v.\n\n"
        "- shells with matrices: Y11, Y22, Y12, G [N/m], energy of shear 2 G E12^2; B1, "
        "B2, "
        "B12, B66\n  [N m]. Nothing is lost%s;\n"
        "- orthotropic solids and shells of one thickness (CalculiX: ENGINEERING "
        "CONSTANTS): E1, E2,\n  nu12, G12, rho, h, h the effective thickness. Lost: they "
        "bend with %.3g times B1, %.3g times B2\n  and %.3g times B66;\n",
        f->warp, law.softens ? " but the softening of bending" : "",
        Y[LAW_WARP] * law.thickness * law.thickness / 12 / B[LAW_WARP],
        Y[LAW_WEFT] * law.thickness * law.thickness / 12 / B[LAW_WEFT],
        Y[LAW_SHEAR] * law.thickness * law.thickness / 12 / B[LAW_SHEAR]);
    put_softening(j, out);
    if (j->scene.shape == SCENE_FLAT && law_is_aligned(&law))
        output_print(out,
                     "- springs and XPBD: `value` [N/m], `compliance` [m/N] along u, v "
                     "and diagonals. Lost: Y12, which is G\n  in a net of springs;\n");
    else
        output_print(out,
                     "- springs and XPBD: none are told. Nets along u and v cannot hold "
                     "this warp;\n");
    output_print(
        out,
        "- angles between two triangles, k theta^2 / 2: k along u, v and diagonals. Lost: "
        "B12%s;\n"
        "- simulators with isotropic values only: E, nu, rho, h of the mean over all "
        "directions. Lost: the\n  weft's membrane is %.3g times, its bending %.3g times as "
        "stiff as the warp's, and shear is %.3g\n  times as stiff as this mean's. "
        "`clothbench study fabrics` measures what that costs.\n",
        law_is_aligned(&law) ? "" : ", B13 and B23, which couple bending to twist",
        Y[LAW_WEFT] / Y[LAW_WARP], B[LAW_WEFT] / B[LAW_WARP],
        Y[LAW_SHEAR] * 2 * (1 + law.poisson) / (law.young * law.thickness));
    if (*j->misfit.text)
        output_print(out, "\nSprings are no plane stress: %s.\n", j->misfit.text);
    output_print(out, "\n");
}

static void put_parameters(const struct export_job *j, struct output *out)
{
    const bool flat = j->scene.shape == SCENE_FLAT;

    if (j->scene.is_fabric) {
        put_fabric_parameters(j, out);
        return;
    }
    output_print(
        out, "## Parameters\n\n"
             "materials.csv. They follow from E, nu, rho and h by rule; none is fitted.\n\n"
             "- finite elements and shells: E, nu, rho, h as they are;\n"
             "- mass of a vertex: areal mass times its share of the area;\n");
    if (flat)
        output_print(
            out, "- springs along u, v and both diagonals of each cell: `value` [N/m]; on "
                 "square cells\n  E h/(1-nu^2) - G h straight, G h diagonal, half on the "
                 "rim;\n- XPBD: `compliance` = 1/stiffness [m/N], of C = length - "
                 "rest_length;\n");
    else
        output_print(out,
                     "- springs: none are told; the matched ones are for flat sheets;\n");
    output_print(
        out,
        "- bending by the angle between two triangles, k theta^2 / 2: k = D |e|^2 "
        "/ (A1 + A2) [N m],\n  e their edge, A1, A2 their areas%s.\n  A triangle whose "
        "three vertices are held does not bend and counts as no area: at a clamp\n  k is D "
        "|e|^2 / A, twice as much%s. With the plain k\n  a clamp is too soft, by an error "
        "of first order in the cell; with this one of second.\n",
        flat ? " (`hinge u`, `hinge v`, `hinge diagonal`)" : "",
        flat ? " (`hinge u held`, `hinge v held`)" : "");
    if (*j->misfit.text)
        output_print(out, "\nSprings are no plane stress: %s.\n", j->misfit.text);
    output_print(out, "\n");
}

static void put_score(const struct export_job *j, struct output *out)
{
    const struct truth *known = &j->known;
    struct message why = {""};

    output_print(out,
                 "## Frames, and how they are scored\n\n"
                 "Positions of all vertices of the sheet at each time: a CSV with lines "
                 "t,u,v,x,y,z in any\norder, OBJ or PLY a frame, or NPZ or HDF5 with "
                 "xyz [frames][n][3], uv [n][2], t [frames]\n(in Python: "
                 "clothbench.frames.write(path, t, uv, xyz)).\n\n");
    if (known->claimed == 1)
        output_print(out, "The truth is known at %g s", known->time[0]);
    else if (known->claimed)
        output_print(out, "The truth is known at %d times from %g to %g s", known->claimed,
                     known->time[0], known->time[known->claimed - 1]);
    else if (truth_plan_check(&j->scene, &why) == STATUS_OK)
        output_print(out,
                     "No truth is stored: `clothbench truth scene.yaml` makes one in "
                     "results/truths, where score\nfinds it if CLOTHBENCH_TRUTHS names "
                     "that folder");
    else
        output_print(out, "No truth is stored: %s", why.text);
    output_print(out, "%s.\n",
                 known->claimed ? " (times.csv, with its error bar [m])" : "");
    if (known->claimed)
        output_print(out, "What it is: %s.\n", known->source);
    output_print(
        out, "Every point of a 100 x 100 grid over (u,v) is compared, yours bilinear "
             "between vertices:\n\n    clothbench score scene.yaml FRAMES\n\n"
             "prints the rms distance over the length at each of these times, the truth's "
             "error bar, and what\nyour net alone would cost.\n");
}

static enum status write_readme(struct export_job *j, struct output *out)
{
    put_title(j, out);
    put_physics(j, out);
    put_held(&j->held, out);
    put_parameters(j, out);
    put_score(j, out);
    return STATUS_OK;
}

/* --- the command --- */

/* The files in their order: README.md prints what materials.csv found. */
static const struct {
    const char *name;
    const char *format; /* of --format that picks it; NULL: it is always written         */
    unsigned need;      /* of the scene, without which it is left out; 0: none           */
    enum status (*write)(struct export_job *j, struct output *out);
} files[] = {
    {"rest.obj", "obj", 0, export_mesh_obj},
    {"rest.ply", "ply", 0, export_mesh_ply},
    {"rest.csv", "csv", 0, export_mesh_csv},
    {"held.csv", NULL, 0, export_held_csv},
    {"materials.csv", NULL, 0, export_numbers_materials},
    {"times.csv", NULL, 0, export_numbers_times},
    {"obstacles.csv", NULL, SCENE_NEED_CONTACT, export_numbers_obstacles},
    {"paths.csv", NULL, SCENE_NEED_MOVING_SUPPORTS, export_numbers_paths},
    {"loads.csv", NULL, SCENE_NEED_LOADS, export_numbers_loads},
    {"velocities.csv", NULL, SCENE_NEED_INITIAL_MOTION, export_numbers_velocities},
    {"scene.yaml", NULL, 0, write_scene},
    {"scene.usda", NULL, 0, export_usd},
    {"README.md", NULL, 0, write_readme},
};
enum { FILES = sizeof files / sizeof *files };

typedef enum status write_one(struct export_job *j, struct output *out);

static enum status write_file(struct export_job *j, const char *name, write_one *write,
                              const char *folder, struct message *why)
{
    struct output *out = NULL;
    char path[4096];
    enum status st;

    if (snprintf(path, sizeof path, "%s/%s", folder, name) >= (int)sizeof path)
        return status_fail(why, STATUS_FILE, "%.60s...: the path is too long", folder);
    TRY(output_create(path, &out, why));
    TRY(write(j, out));
    TRY(output_close(&out, why));
out:
    output_discard(out);
    return st;
}

/* Writes all files that the scene needs; `format` picks one of the rest mesh, NULL all. */
static enum status write_all(struct export_job *j, const char *format, const char *folder,
                             struct message *why)
{
    const unsigned needs = scene_needs(&j->scene);
    enum status st = STATUS_OK;

    for (int n = 0; n < FILES; n++) {
        const bool picked = !format || !files[n].format || !strcmp(format, files[n].format);
        if (picked && (!files[n].need || needs & files[n].need))
            TRY(write_file(j, files[n].name, files[n].write, folder, why));
    }
    for (j->body = 0; j->body < j->scene.obstacle_count; j->body++) {
        char name[32];
        snprintf(name, sizeof name, MESH_FILE, j->body);
        if (j->scene.obstacles[j->body].kind == OBSTACLE_MESH)
            TRY(write_file(j, name, export_mesh_body, folder, why));
    }
out:
    return st;
}

static enum status read_scene(struct export_job *j, const struct command_line *line,
                              struct message *why)
{
    int count;
    const char *const *given = command_values(line, "--set", &count);
    char *path = NULL;
    enum status st;

    settings_set_all(&j->settings, count, given);
    TRY(scene_file_find(line->words[0], &path, why));
    count = j->settings.count;
    TRY(truth_plan_scene(path, &j->settings, &j->scene, why));
    j->undamped = j->settings.count > count;
out:
    free(path);
    return st;
}

/* Checks the whole request before anything is written. */
static enum status prepare(struct export_job *j, const struct command_line *line,
                           struct message *why)
{
    const char *format = command_value(line, "--format");
    enum status st;

    if (!command_given(line, "--points"))
        TRY(status_fail(why, STATUS_INPUT,
                        "how many vertices? --points N,M, as in --points 21,21"));
    if (!command_given(line, "--out"))
        TRY(status_fail(why, STATUS_INPUT, "where to? --out FOLDER, a new one"));
    TRY(command_pair(line, "--points", 2, EXPORT_SHEET_MOST, j->sheet.points, why));
    if (format && strcmp(format, "obj") && strcmp(format, "ply") && strcmp(format, "csv"))
        TRY(status_fail(why, STATUS_INPUT, "--format %s: obj, ply or csv", format));
    TRY(read_scene(j, line, why));
    if (scene_needs(&j->scene) & SCENE_NEED_OWN_MATERIALS)
        TRY(status_fail(why, STATUS_UNSUPPORTED,
                        "%s has sheets with materials of their own, but export writes one "
                        "material",
                        j->scene.name));
    j->sheet.scene = &j->scene;
    TRY(export_held_find(&j->sheet, &j->held, why));
    TRY(truth_judged(&j->scene, &j->known, why));
out:
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *out = command_value(line, "--out");
    struct folder_aside aside = {0};
    struct export_job j = {0};
    enum status st;

    TRY(prepare(&j, line, why));
    TRY(folder_aside_open(out, &aside, why));
    TRY(write_all(&j, command_value(line, "--format"), aside.temporary, why));
    TRY(folder_aside_commit(&aside, why));
    if (*j.held.doubt.text)
        fprintf(stderr, "export: %s\n", j.held.doubt.text);
    fprintf(stderr, "%s, %d vertices, in %s; begin with README.md there\n", j.scene.name,
            export_sheet_vertices(&j.sheet), out);
out:
    folder_aside_discard(&aside);
    truth_clear(&j.known);
    export_held_clear(&j.held);
    settings_clear(&j.settings);
    scene_clear(&j.scene);
    return st;
}

static const struct command_option options[] = {
    {"--points", "N,M", false, "vertices along u and v of a sheet (required)"},
    {"--out", "FOLDER", false, "a new folder for the files (required)"},
    {"--format", "obj|ply|csv", false, "format of the rest mesh (all three)"},
    {"--set", "KEY=VALUE", true, "change a key of the scene"},
    {NULL, NULL, false, NULL},
};

const struct command export_command = {
    .name = "export",
    .summary = "write a scene for your own simulator",
    .arguments = "SCENE [OPTION]...",
    .text =
        "Writes what another simulator needs to run a scene: the rest mesh with u and v,\n"
        "the vertices that are held and those outside the sheet that make an edge a\n"
        "clamp, the material as elements, springs and XPBD need it, the times at which\n"
        "the truth is known, obstacles, loads and moving supports, the scene itself,\n"
        "also in OpenUSD, and README.md with the rules on one page. The physics are those\n"
        "of the scene's truth. Either all files appear or none does; a folder that is not\n"
        "empty is left alone.\n",
    .examples = "export edge_drop --points 21,21 --out edge_drop_21\n"
                "export sphere --points 51,51 --format obj --out ball\n",
    .least = 1,
    .most = 1,
    .options = options,
    .run = run,
};
