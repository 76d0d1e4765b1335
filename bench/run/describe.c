#include "bench/run/describe.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/run_surface.h"
#include "bench/harness/warnings.h"
#include "bench/data/printer.h"
#include "models/clock.h"
#include "models/contact/contact.h"
#include "models/damping.h"
#include "models/grid.h"
#include "models/linalg/blas_kernel.h"
#include "models/metric/drape.h"
#include "models/metric/metric.h"
#include "models/pattern.h"
#include "models/vector.h"

static void describe_discretization(const struct scene *scene,
                                    const struct discretization *d, FILE *file)
{
    if (scene->pattern && scene->pattern->mesh.nodes && !d->mesh)
        fprintf(file, "discretization  the scene's triangles%s, kinematics %s",
                d->refine == 0   ? ""
                : d->refine == 1 ? ", each cut into four"
                                 : ", each cut into four again and again",
                option_kinematics[d->kinematics]);
    else
        fprintf(file,
                "discretization  %d x %d x %d points, degree (%d,%d,%d), kinematics %s",
                d->points[0], d->points[1], d->points[2], d->degree[0], d->degree[1],
                d->degree[2], option_kinematics[d->kinematics]);
    fprintf(file, ", remedy %s", option_remedy[d->remedy]);
    if (d->gauss[0] || d->gauss[1] || d->gauss[2])
        fprintf(file, ", Gauss (%d,%d,%d)", d->gauss[0], d->gauss[1], d->gauss[2]);
    for (int i = 0; i < 3; i++)
        if (d->knot_count[i])
            fprintf(file, ", %c knots as given", "uvw"[i]);
    fprintf(file, "%s\n", d->weight_count ? ", weights as given" : "");
}

/* Says of a sheet that is no rectangle what it has of its box. */
static struct message shape_of(const struct scene *scene)
{
    struct message text = {""};

    if (scene->pattern)
        status_fail(&text, STATUS_OK, "%.4g m^2 with an outline in ", scene_area(scene));
    return text;
}

static void describe_fabric(const struct scene *scene, FILE *file)
{
    const struct law_fabric *f = &scene->fabric;
    const double *Y = f->membrane, *B = f->bending;

    fprintf(
        file,
        "scene           %s: %s%g x %g m; a fabric of %g kg/m^2, warp at %g degrees to u\n"
        "membrane        Y11 %g, Y22 %g, Y12 %g, G %g N/m\n"
        "bending         B1 %g, B2 %g, B12 %g, B66 %g N m; h_eff %.4g m\n",
        scene->name, shape_of(scene).text, scene->length, scene->width, f->areal_density,
        f->warp, Y[0], Y[1], Y[2], Y[3], B[0], B[1], B[2], B[3], scene->thickness);
    const struct law law = scene_law(scene);
    if (law.softens)
        fprintf(file,
                "softening       C1 %g, C2 %g N m^2, to curvatures of %.4g, %.4g 1/m\n",
                law.soft[0].second, law.soft[1].second, law.soft[0].most, law.soft[1].most);
}

static void describe_scene(const struct scene *scene, FILE *file)
{
    if (scene->is_fabric)
        describe_fabric(scene, file);
    else
        fprintf(file,
                "scene           %s: %s%g x %g m, h = %g m, E = %g Pa, nu = %g, rho = %g "
                "kg/m^3\n",
                scene->name, shape_of(scene).text, scene->length, scene->width,
                scene->thickness, scene->young, scene->poisson, scene->density);
    for (int k = 0; k < scene->sheets; k++) {
        const struct scene_own *own = &scene->own[k];
        if (own->density > 0)
            fprintf(file,
                    "sheet %d         E = %g Pa, nu = %g, rho = %g kg/m^3 of its own\n",
                    k + 1, own->young, own->poisson, own->density);
    }
    fprintf(file, "damping         %s", damping_words[scene->damping.kind]);
    if (scene->damping.kind == DAMPING_RAYLEIGH)
        fprintf(file, ", alpha %g 1/s, beta %g s", scene->damping.alpha,
                scene->damping.beta);
    else if (scene->damping.kind != DAMPING_NONE)
        fprintf(file, " %g", scene->damping.value);
    if (scene_needs(scene) & SCENE_NEED_INITIAL_MOTION)
        fprintf(file,
                "\nstarts with     velocity (%g, %g, %g) m/s, spin (%g, %g, %g) rad/s",
                scene->velocity[0], scene->velocity[1], scene->velocity[2], scene->spin[0],
                scene->spin[1], scene->spin[2]);
    if (scene_ripples(scene))
        fprintf(
            file, "\nripples with    velocity (%g, %g, %g) m/s in waves of %g m, seed %d",
            scene->ripple[0], scene->ripple[1], scene->ripple[2], scene->wave, scene->seed);
    fprintf(file, "\ntime            to %g s in steps of %g s\n", scene->end, scene->step);
}

/* Prints the law by which the sheet meets bodies and itself, and how it rests. */
static void describe_contact(const struct run *run, FILE *file)
{
    const struct scene *scene = &run->scene;
    const struct contact_law self = contact_law_self(scene), body = contact_law_body(scene);
    const double weight = contact_law_weight(scene);
    char bodies[80] = "", itself[80] = "";
    struct message line;

    if (!contact_wanted(scene) || kinematics_rebuilds(run->discretization.kinematics))
        return;
    if (scene->obstacle_count)
        snprintf(bodies, sizeof bodies, "from %.4g m off bodies, range %.4g m; ",
                 body.start, body.range);
    if (scene->contact.self)
        snprintf(itself, sizeof itself,
                 "from t = %.4g m off itself, range %.4g m, friction %g; ", self.start,
                 self.range, scene->contact.friction);
    snprintf(line.text, sizeof line.text,
             "%s%skappa = %.4g Pa; distances are those of the "
             "mid-surface",
             bodies, itself, self.stiffness);
    wrap_item("contact", 16, line.text, file);
    snprintf(line.text, sizeof line.text,
             "what touches a body leaves it at %.3g m/s at most%s, and creeps at %.3g m/s "
             "at most where friction holds it",
             body.rebound, scene->contact.self ? ", layers part twice as fast" : "",
             body.creep);
    if (isfinite(body.rebound))
        wrap_item("", 16, line.text, file);
    if (!(weight > 0))
        return;
    snprintf(
        line.text, sizeof line.text,
        "under its weight of %.4g Pa it rests %.4g m off a body, twice as far off itself, "
        "and leaves it over lambda = %.2g m",
        weight, contact_law_distance(&body, weight),
        contact_law_edge(&body, scene_bending_stiffness(scene), weight));
    wrap_item("", 16, line.text, file);
}

/* Gamma knows the weight, and nothing of what else may bend a sheet. */
enum { BENDS_TOO = SCENE_NEED_LOADS | SCENE_NEED_PRESSURE };

/* Returns how far its weight bends a cantilever of this Gamma, in words. */
static const char *bending(double gamma)
{
    return gamma == 0 ? "no gravity"
           : gamma <= SCENE_GAMMA_ONE_PERCENT
               ? "linear theory is within 1 % of a cantilever"
           : gamma <= SCENE_GAMMA_TEN_PERCENT
               ? "linear theory is within 10 % of a cantilever"
           : gamma < SCENE_GAMMA_CLOTH
               ? "it bends far, though not as far as cloth, from 7e4"
               : "as of cloth";
}

/* Prints each warning in lines of a table's width. */
static void describe_warnings(const struct run *run, FILE *file)
{
    char *text = NULL, *rest;
    size_t size;
    FILE *lines = open_memstream(&text, &size);

    if (!lines)
        return;
    warnings_print(run, "", lines);
    if (fclose(lines) == 0)
        for (char *line = strtok_r(text, "\n", &rest); line;
             line = strtok_r(NULL, "\n", &rest))
            wrap_item("warning:", sizeof "warning:", line, file);
    free(text);
}

void describe_setup(const struct run *run, FILE *file)
{
    const struct model *model = run->model;
    struct model_size size = {0};
    struct message note = {{0}};

    model->size(run->state, &size);
    if (model->describe)
        model->describe(run->state, &note);
    describe_scene(&run->scene, file);
    describe_contact(run, file);
    fprintf(file, "Gamma           %.4g (weight against bending%s: %s)\n",
            scene_gamma(&run->scene),
            scene_needs(&run->scene) & BENDS_TOO ? ", without loads and pressure" : "",
            bending(scene_gamma(&run->scene)));
    fprintf(file, "model           %s: %s\n", model->name, model->title);
    describe_discretization(&run->scene, &run->discretization, file);
    fprintf(
        file,
        "unknowns        %ld of %ld nodes, as %s; solver %s, %ld numbers in its factor\n",
        size.unknowns, size.nodes, size.unknown_basis ? size.unknown_basis : "-",
        size.solver ? size.solver : "none", size.factor_entries);
    if (*run->adapted.text)
        wrap_item("note", 16, run->adapted.text, file);
    if (*note.text)
        wrap_item("note", 16, note.text, file);
    fprintf(file, "set-up          %.3f ms\n", 1e3 * run->create_seconds);
    describe_warnings(run, file);
}

void describe_motion(const struct motion *m, FILE *file)
{
    const struct counters *c = &m->counters;
    struct message doubt = {""};

    fprintf(file, "frames          %d of %d, to t = %g s\n", m->frames, m->frame_count,
            m->time);
    if (m->steps) {
        struct clock_summary s = clock_summarise(m->seconds, m->steps);
        fprintf(file,
                "ms a frame      median %.4f, min %.4f, quartiles %.4f and %.4f, max %.4f, "
                "first %.4f\n",
                1e3 * s.median, 1e3 * s.min, 1e3 * s.lower, 1e3 * s.upper, 1e3 * s.max,
                1e3 * m->seconds[0]);
    }
    fprintf(file,
            "work            %ld steps in %ld pieces, %ld assemblies, %ld factorisations, "
            "%ld solves, %ld iterations\n",
            c->steps, c->substeps > c->steps ? c->substeps : c->steps, c->assemblies,
            c->factorisations, c->solves, c->iterations);
    if (c->viscous)
        fprintf(file,
                "viscosity       in %ld steps, for a while after each that Newton's method "
                "could "
                "not take without (discretization.viscosity)\n",
                c->viscous);
    if (m->model->doubt)
        m->model->doubt(m->state, &doubt);
    if (*doubt.text)
        fprintf(file, "warning: %s\n", doubt.text);
    fprintf(file, "threads         %d OpenMP, %d BLAS (%s kernel)\n", omp_get_max_threads(),
            blas_kernel_threads(), blas_kernel_name());
    fprintf(file, "peak memory     %.1f MB\n", 1e-6 * (double)clock_peak_memory());
}

/* A component of a force below this part of it is 0 to people. */
static const double ROUND_OFF = 1e-9;

int describe_forces(const struct run *run, double force[DESCRIBE_FORCES][6])
{
    const int supports = run->scene.support_count,
              count = supports + run->scene.obstacle_count;

    if (!run->model->forces || !count || count > DESCRIBE_FORCES ||
        run->model->forces(run->state, force, force + supports) != STATUS_OK)
        return 0;
    for (int n = 0; n < 6 * count; n++) { /* what is but round-off beside the whole */
        const double *f = force[n / 6] + n % 6 / 3 * 3;
        if (fabs(f[n % 3]) < ROUND_OFF * vector_length(f))
            force[n / 6][n % 6] = 0;
    }
    return isnan(force[0][0]) ? 0 : count;
}

static void add_forces(struct dataset *table, const struct run *run)
{
    const int supports = run->scene.support_count;
    double f[DESCRIBE_FORCES][6];

    for (int n = 0, count = describe_forces(run, f); n < count; n++) {
        const bool body = n >= supports;
        dataset_line(table, "force of %s %d", body ? "obstacle" : "support",
                     body ? n - supports : n);
        dataset_add(table, "(%.4g, %.4g, %.4g)", f[n][0], f[n][1], f[n][2]);
        dataset_add(table, "N");
    }
}

/* Counts where the sheet passes through itself: on the grid, or on its own triangles. */
static double crossings(const struct run *run, const double *xyz)
{
    struct run_surface net SCOPED(run_surface_clear) = {.flat = {0}};

    if (!run->scene.pattern)
        return metric_intersections(&run->scene, xyz);
    if (run_surface_net(&net, run) != STATUS_OK)
        return NAN;
    run_surface_sample(&net, run->model, run->state);
    return run_surface_crossings(&net);
}

enum status describe_state(const struct run *run, double t, FILE *file)
{
    static const struct dataset_column columns[] = {{""}, {"value"}, {"unit"}};
    const struct scene *scene = &run->scene;
    struct energy energy = {NAN, NAN, NAN}; /* of a model that has no such energy */
    char caption[64];
    struct arena own = {0};
    double *xyz = arena_take(&own, GRID_POINTS * 3, sizeof *xyz);

    model_sample(run->model, run->state, xyz);
    if (run->model->energy)
        run->model->energy(run->state, &energy);
    const bool obstacles = scene->obstacle_count > 0;
    const struct {
        const char *name;
        double value;
        const char *unit;
    } row[] = {
        {"drop", metric_drop(scene, xyz), "L"},
        {"angle", metric_angle(scene, xyz), "degrees"},
        {"largest stretch", metric_stretch(scene, xyz), "1"},
        {"roughness", metric_roughness(scene, xyz), "1"},
        {"penetration", obstacles ? metric_penetration(scene, t, xyz) : NAN, "m"},
        {"drape coefficient", drape_coefficient(scene, xyz), "1"},
        {"folds", drape_folds(scene, xyz), "1"},
        {"self-intersections", crossings(run, xyz), "pairs"},
        {"kinetic energy", energy.kinetic, "J"},
        {"elastic energy", energy.elastic, "J"},
        {"potential energy", energy.potential, "J"},
    };
    arena_clear(&own);
    snprintf(caption, sizeof caption, "At t = %g s:", t);
    struct dataset *table = dataset_create(3, columns, caption);
    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        const bool drapes =
            !strcmp(row[n].name, "drape coefficient") || !strcmp(row[n].name, "folds");
        if ((drapes && isnan(row[n].value)) ||
            (!obstacles && !strcmp(row[n].name, "penetration")))
            continue;
        dataset_line(table, "%s", row[n].name);
        if (!strcmp(row[n].unit, "pairs"))
            dataset_add(table, "%.0f", row[n].value);
        else
            dataset_add(table, "%.6g", row[n].value);
        dataset_add(table, "%s", row[n].unit);
    }
    add_forces(table, run);
    fputc('\n', file);
    const enum status st =
        printer_table(&(struct printer){TABLE_TEXT, file}, table, NULL, NULL);
    /* standard error that takes nothing is no reason to fail */
    return st == STATUS_FILE ? STATUS_OK : st;
}
