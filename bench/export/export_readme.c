#include "bench/export/export_readme.h"

#include <math.h>

#include "bench/truth/truth_plan.h"
#include "models/damping.h"

static void put_title(const struct export_sheet *s, struct output *out)
{
    const struct scene *c = s->scene;
    const double *g = c->gravity;

    output_print(
        out,
        "# %s for your simulator\n\nA %s sheet, %g m (u) by %g m (v), %g m thick: E = "
        "%g Pa, nu = %g, rho = %g kg/m^3; gravity\n%g %g %g m/s^2; Gamma = rho g h L^3 "
        "/ D = %.4g.\nSource: %s.\n\n",
        c->name, scene_shape_name((int)c->shape), c->length, c->width, c->thickness,
        c->young, c->poisson, c->density, g[0] + 0.0, g[1] + 0.0, g[2] + 0.0,
        scene_gamma(c), c->source);
    output_print(out, "SI units; x, y, z right-handed.");
    for (int n = 0; n < 3; n++) {
        static const double corner[3][3] = {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}};
        double x[3];
        scene_rest_point(c, corner[n], x);
        output_print(out, "%s u = %g, v = %g is at (%.4g, %.4g, %.4g)",
                     n ? "," : " At rest", corner[n][0], corner[n][1], x[0] + 0.0,
                     x[1] + 0.0, x[2] + 0.0);
    }
    output_print(
        out,
        ".\nVertex j %d + i is at u = i/%d, v = j/%d. Files count vertices from 0, "
        "OBJ from 1.\nTriangles are counter-clockwise seen from u x v; the diagonals "
        "alternate.\n\n",
        s->points[0], s->points[0] - 1, s->points[1] - 1);
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

static void put_physics(const struct scene *c, const struct export_readme *r,
                        struct output *out)
{
    const unsigned needs = scene_needs(c);

    output_print(out, "## Physics of the truth\n\n");
    put_damping(c, r->undamped, r->known->closed && c->support_count, out);
    output_print(out,
                 "- From t = 0 at rest in the rest shape%s, without stress; large "
                 "displacements; no self-contact.\n",
                 needs & SCENE_NEED_INITIAL_MOTION ? " but for velocities.csv [m/s]" : "");
    if (needs & SCENE_NEED_DRAG)
        output_print(out,
                     "- Body drag: %g kg/m^3/s times (wind - velocity) per volume, wind "
                     "%g %g %g m/s: times area and h per vertex.\n",
                     c->drag, c->wind[0], c->wind[1], c->wind[2]);
    if (needs & SCENE_NEED_CONTACT)
        output_print(out,
                     "- Obstacles stand still: obstacles.csv; normals point outward; "
                     "Coulomb friction. The sheet's faces, h/2 off its middle, touch.\n");
    if (needs & SCENE_NEED_LOADS)
        output_print(out,
                     "- Forces that keep their direction from t = 0: loads.csv [N].\n");
    if (needs & SCENE_NEED_MOVING_SUPPORTS)
        output_print(out, "- Held vertices with a `path` move: rest + paths.csv [s, m], "
                          "linear between rows, constant outside.\n");
    output_print(out, "\n");
}

static void put_held(const struct export_readme *r, struct output *out)
{
    const struct export_held *h = r->held;

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

static void put_parameters(const struct export_sheet *s, const char *misfit,
                           struct output *out)
{
    const bool flat = s->scene->shape == SCENE_FLAT;

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
    if (*misfit)
        output_print(out, "\nSprings are no plane stress: %s.\n", misfit);
    output_print(out, "\n");
}

static void put_score(const struct export_sheet *s, const struct truth_made *known,
                      struct output *out)
{
    struct message why = {""};

    output_print(out,
                 "## Frames, and how they are scored\n\n"
                 "Positions of all vertices of the sheet at each time: a CSV with lines "
                 "t,u,v,x,y,z in any\norder, OBJ or PLY a frame, or NPZ or HDF5 with "
                 "xyz [frames][n][3], uv [n][2], t [frames]\n(clothbench.py: "
                 "frames.write(path, t, uv, xyz)).\n\n");
    if (known->claimed == 1)
        output_print(out, "The truth is known at %g s", known->time[0]);
    else if (known->claimed)
        output_print(out, "The truth is known at %d times from %g to %g s", known->claimed,
                     known->time[0], known->time[known->claimed - 1]);
    else if (truth_plan_check(s->scene, &why) == STATUS_OK)
        output_print(out,
                     "No truth is stored: `clothbench truth scene.yaml` makes one in "
                     "results/truths, where score\nfinds it if CLOTHBENCH_TRUTHS names "
                     "that folder");
    else
        output_print(out, "No truth is stored: %s", why.text);
    output_print(out, "%s.\n",
                 known->claimed ? " (times.csv, with its error bar [m])" : "");
    if (known->claimed)
        output_print(out, "What it is: %s.\n", known->note);
    output_print(
        out, "Every point of a 100 x 100 grid over (u,v) is compared, yours bilinear "
             "between vertices:\n\n    clothbench score scene.yaml FRAMES\n\n"
             "prints the rms distance over the length at each of these times, the truth's "
             "error bar, and what\nyour net alone would cost.\n");
}

enum status export_readme_write(const struct export_sheet *s, const struct export_readme *r,
                                struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(export_sheet_open(s, "README.md", &out, why));
    put_title(s, out);
    put_physics(s->scene, r, out);
    put_held(r, out);
    put_parameters(s, r->misfit, out);
    put_score(s, r->known, out);
    TRY(output_close(out, why));
out:
    return st;
}
