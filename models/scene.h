/* scene.h - a scene: physics only, SI units. No numerics (those are discretization.h).
 *
 * A sheet of length L (u), width W (v) and thickness h (w), with (u,v,w) in [0,1]^3, lies
 * flat at rest,
 *   X(u,v,w) = origin + u L e_u + v W e_v + (w - 1/2) h e_w,   e_w = e_u x e_v,
 * so that `origin` is the mid-surface corner; or it has the curved rest shape of cloak.h.
 *
 * A scene may have several flat sheets, alike but for where they lie and what they are made
 * of. They share u: sheet k of K has the columns of the material grid that grid_columns
 * tells, the rest is void. Everywhere u is this one of the scene, unless it is called s,
 * which runs from 0 to 1 along each sheet. With one sheet they are the same.
 */
#ifndef SCENE_H
#define SCENE_H

#include <stdbool.h>

#include "models/law/law.h"
#include "models/scene_motion.h"
#include "models/status.h"

/* The components of a support that are held; bits. */
enum { FIX_X = 1, FIX_Y = 2, FIX_Z = 4, FIX_XYZ = 7 };

enum damping_kind {
    DAMPING_NONE,
    DAMPING_VELOCITY_SCALE, /* v <- value v after each step; not a physical rate      */
    DAMPING_VELOCITY_RATE,  /* v <- (1 - value dt) v after each step          [1/s]   */
    DAMPING_MASS,           /* C = value M                                    [1/s]   */
    DAMPING_RAYLEIGH,       /* C = alpha M + beta K                      [1/s], [s]   */
};

enum scene_shape {
    SCENE_FLAT,
    SCENE_CLOAK, /* cloak.h */
};

enum { SCENE_MAX_SHEETS = 8 };

/* The place of a flat sheet at rest. */
struct scene_pose {
    double origin[3], axis_u[3], axis_v[3]; /* [m]; axes orthonormal */
};

/* The isotropic material of one of several sheets; density 0: the scene's. */
struct scene_own {
    double young, poisson, density; /* [Pa], [1], [kg/m^3]                             */
};

struct scene_damping {
    enum damping_kind kind;
    double value;
    double alpha, beta;
};

/* All material points with lo <= (u,v,w) <= hi are held in the components of `fix` at
 * rest position as `motion` moves it. An edge is lo = hi in one direction, [0,1] in the
 * others.
 *
 * A gripper, which has `from` or `until`, takes at `from` what nobody holds then, where it
 * is: from then on these points go with the motion as if they were a part of what moves so.
 * It holds points, and no direction of the sheet beside them. */
struct scene_support {
    double lo[3], hi[3];
    unsigned fix;
    double from, until; /* takes hold, lets go; until 0: never                    [s]  */
    struct scene_motion motion; /*                                         owned   */
    int line;                   /* in the scene file; 0 if made in memory          */
    int sheet;                  /* named by the scene file, from 1; 0: none        */
    int part_count;       /* of the region, where it is no box, but in this one       */
    double (*part)[3][2]; /* [part_count] corners (u,v) of triangles, or of segments or
                             points where corners coincide                    owned   */
};

/* A dead force, spread evenly over the material points lo <= (u,v,w) <= hi: an edge, a
 * face, an area, a point. It keeps its direction however the sheet turns. */
struct scene_load {
    double lo[3], hi[3];
    double force[3]; /* in all                                                [N]     */
    int sheet;       /* named by the scene file, from 1; 0: none                       */
};

/* How sheets meet bodies, themselves and each other (models/contact/contact_law.h); 0: by
 * rule. */
struct scene_contact {
    bool self;        /* sheets meet themselves and each other                     */
    double thickness; /* distance of mid-surfaces where contact starts; h    [m]   */
    double range;     /* from there to the wall; thickness / 2               [m]   */
    double stiffness; /* pressure at half the range                          [Pa]  */
    double friction;  /* Coulomb coefficient of the sheet on itself                */
};

enum obstacle_kind {
    OBSTACLE_PLANE,
    OBSTACLE_SPHERE,
    OBSTACLE_CAPSULE,
    OBSTACLE_BOX,
    OBSTACLE_MESH,
    OBSTACLE_KINDS
};

struct pattern;

struct obstacle_mesh; /* models/bodies/body_mesh.h; one piece of memory */

/* A body that the sheet may not enter; rigid. Places are those without its motion. */
struct scene_obstacle {
    enum obstacle_kind kind;
    double point[3];   /* on the plane; centre of sphere and box; the capsule's one end,
                          the origin of a mesh                                 [m]     */
    double end[3];     /* capsule: the other end                               [m]     */
    double normal[3];  /* plane: outward, any length > 0                               */
    double radius;     /* sphere, capsule                                      [m] > 0 */
    double size[3];    /* box: its edges' lengths                              [m] > 0 */
    double axis[2][3]; /* box: directions of its first two edges, orthonormal         */
    struct obstacle_mesh *mesh; /*                                            owned   */
    char *file;      /* of the mesh, as the scene names it                   owned   */
    double scale;    /* mesh: metres a unit of the file                      > 0     */
    double friction; /* Coulomb coefficient, >= 0                                    */
    struct scene_motion motion; /*                                             owned   */
};

/* Air that resists what moves through it (models/mechanics/air.h). */
struct scene_air {
    double density;    /* 0: there is none                               [kg/m^3]      */
    double drag[2];    /* coefficients along the normal and along the sheet   [1]      */
    int wind_count;    /* rows [t, x, y, z] of its velocity, t increasing; linear
                          between, constant outside; none: still air                   */
    double (*wind)[4]; /*                                         [s, m/s]     owned   */
};

struct scene {
    char *name;   /* [a-z0-9_]+                                             owned     */
    char *source; /* where the numbers come from                            owned     */
    char *about;  /* the events, a line for lists; NULL: none               owned     */
    char *text;   /* the file as read, with the settings applied below it and sums of
                     the meshes that it names: the same text, the same scene  owned    */

    double length, width, thickness; /*                                       [m] > 0 */
    int sheets;                      /* 0, 1: one                                    */
    union {
        struct scene_pose pose[SCENE_MAX_SHEETS]; /* of the sheets                  */
        struct {
            double origin[3], axis_u[3], axis_v[3]; /* of the first                   */
        };
    };
    struct scene_own own[SCENE_MAX_SHEETS]; /* materials of sheets that have their own */
    struct pattern *pattern; /* of a sheet that is no rectangle (pattern.h), in the box of
                                length and width; NULL: it is one               owned    */
    char *pattern_file; /* of its mesh, as the scene names it; NULL: none       owned    */
    enum scene_shape shape; /* at rest                                       */
    double opening, flare;  /* angles of a cloak; opening 360: closed  [deg] */

    double young;   /* E; of a fabric its mean, for people                    [Pa] > 0 */
    double poisson; /* nu; likewise                                        (-1, 0.5)  */
    double density; /* rho; of a fabric mass per area over h_eff         [kg/m^3] > 0 */
    bool is_fabric; /* the law is the fabric's, and h its h_eff             */
    struct law_fabric fabric; /* of a sheet that is not isotropic                     */
    int fabric_row;           /* in law_fabrics, where the file names it              */
    int fabric_mean; /* 1: the sheet is isotropic and has the mean of the fabric's law */

    double gravity[3]; /*                                                  [m/s^2] */
    double drag;       /* body drag c, force c (wind - v) per volume  [kg/m^3/s]   */
    double wind[3];    /*                                                  [m/s]   */
    struct scene_air air;
    double pressure; /* on the face w = 1, against its normal wherever it turns [Pa]  */
    struct scene_damping damping;
    double velocity[3], spin[3]; /* rigid motion at t = 0: velocity + spin x position,
                                    where nothing holds              [m/s], [rad/s]   */
    double ripple[3], wave; /* velocity besides: ripple scene_ripple  [m/s], [m] > 0  */
    int seed;               /* of its waves                                           */

    int support_count;
    struct scene_support *supports; /* owned                                          */
    int load_count;
    struct scene_load *loads; /* owned                                               */
    int obstacle_count;
    struct scene_obstacle *obstacles; /* owned                                        */
    struct scene_contact contact;

    double step, end; /* one frame, duration                              [s] > 0 */
    int snapshot_count;
    double *snapshots; /* times worth keeping, increasing          [s]     owned   */
};

/* The abilities that a scene requires of a model; bits of scene_needs(). */
#define SCENE_NEED_LIST(X)                                                                 \
    X(CONTACT, "contact with obstacles")                                                   \
    X(MOVING_SUPPORTS, "moving supports")                                                  \
    X(PATCH_SUPPORTS, "supports on an area")                                               \
    X(COMPONENT_SUPPORTS, "supports that hold single components")                          \
    X(THICKNESS_SUPPORTS, "supports on part of the thickness")                             \
    X(DRAG, "body drag")                                                                   \
    X(LOADS, "loads")                                                                      \
    X(PRESSURE, "pressure that follows the normal")                                        \
    X(CURVED_REST, "curved rest shape")                                                    \
    X(CLOSED_REST, "rest shape that is closed around")                                     \
    X(FABRIC, "fabrics")                                                                   \
    X(BIAS, "fabrics whose warp runs along neither edge")                                  \
    X(SOFTENING, "bending that softens")                                                   \
    X(INITIAL_MOTION, "initial motion")                                                    \
    X(MOVING_OBSTACLES, "moving obstacles")                                                \
    X(SELF_CONTACT, "contact of the sheet with itself")                                    \
    X(SHEETS, "several sheets")                                                            \
    X(OWN_MATERIALS, "sheets with materials of their own")                                 \
    X(TURNING_CLAMPS, "clamps that turn")                                                  \
    X(OUTLINE, "outlines other than a rectangle, a cone and a ring")                       \
    X(AIR, "air that resists by the normal")                                               \
    X(GRIPPERS, "supports that take hold or let go")

enum scene_need_bit {
#define SCENE_NEED_BIT(name, sentence) SCENE_NEED_BIT_##name,
    SCENE_NEED_LIST(SCENE_NEED_BIT)
#undef SCENE_NEED_BIT
};
enum scene_need {
#define SCENE_NEED_VALUE(name, sentence) SCENE_NEED_##name = 1u << SCENE_NEED_BIT_##name,
    SCENE_NEED_LIST(SCENE_NEED_VALUE)
#undef SCENE_NEED_VALUE
};

#define SCENE_NEED_ALL_OF(name, sentence) SCENE_NEED_##name |
enum { SCENE_NEED_ALL = SCENE_NEED_LIST(SCENE_NEED_ALL_OF) 0 };
#undef SCENE_NEED_ALL_OF

unsigned scene_needs(const struct scene *scene);

/* Returns the area of one sheet at rest [m^2]. */
double scene_area(const struct scene *scene);

/* Tells whether the point (i, j) of the material grid is beside the sheet: a field has NaN
 * there. */
bool scene_void(const struct scene *scene, int i, int j);

/* Writes the names of the bits, comma-separated, into text[size]. */
enum { SCENE_NEEDS_TEXT = 1024 }; /* room for all of them */
void scene_needs_text(unsigned needs, char *text, int size);

/* Makes the scene that tests and the file reader start from: a flat sheet in the x-y plane,
 * L = W = 1 m, h = 0.01 m, E = 1 Pa, nu = 0, rho = 1 kg/m^3, no loads, no supports, 1 s in
 * steps of 5 ms. *scene is overwritten, not freed. Free with scene_clear, which accepts
 * all-zero and leaves all-zero. */
enum status scene_init(struct scene *scene);
void scene_clear(struct scene *scene);

/* Tells whether (u,v) is in the parts of a support's region, or at them, if it has any. */
bool scene_support_has(const struct scene_support *s, double u, double v);

/* Frees what a support that is in no scene owns. */
void scene_support_clear(struct scene_support *s);

/* Adds a copy of *support (its path and parts are copied too). */
enum status scene_add_support(struct scene *scene, const struct scene_support *support);

/* Tells whether a support is a gripper. */
static inline bool scene_grips(const struct scene_support *s)
{
    return s->from > 0 || s->until > 0;
}

/* Adds a copy of *load. */
enum status scene_add_load(struct scene *scene, const struct scene_load *load);

/* Adds a copy of *obstacle, with its path, turn and file, and takes its mesh over. */
enum status scene_add_obstacle(struct scene *scene, const struct scene_obstacle *obstacle);

/* Frees what an obstacle that is in no scene owns, and leaves it empty. */
void scene_obstacle_clear(struct scene_obstacle *obstacle);

/* "flat", "cloak"; NULL ends. */
extern const char *const scene_shape_words[];

/* Returns how many sheets there are, at least 1. */
int scene_sheets(const struct scene *scene);

/* Returns the sheet, from 0, that has u, and computes s along it; a u in the void belongs
 * to the end of the nearest sheet. */
int scene_sheet_at(const struct scene *scene, double u, double *s);

/* Returns u at s of a sheet; scene_sheet_at then returns s to round-off, 0 and 1 exactly.
 */
double scene_sheet_u(const struct scene *scene, int sheet, double s);

/* Returns a support with its range of u as s of the sheets where it begins and ends. Its
 * path is borrowed. */
struct scene_support scene_support_along(const struct scene *scene, int support);

/* Returns u, or, where that is in the void, that of the end of the nearest sheet. */
double scene_sheet_inside(const struct scene *scene, double u);

/* Returns whom a sheet may pass through: "itself", or "itself or another sheet". */
const char *scene_sheet_other(const struct scene *scene);

/* Returns the sheet of an item of so many that stand one sheet's after another's, equally
 * many of each: elements, nodes or rows of a net. */
int scene_sheet_of(const struct scene *scene, int item, int items);

/* Returns the scene with that sheet as its only one, of that sheet's material; supports and
 * loads stay as they are. Borrows all that the scene owns: not to be cleared. */
struct scene scene_sheet(const struct scene *scene, int sheet);

/* Computes e_w = e_u x e_v of the first sheet. */
void scene_normal(const struct scene *scene, double e_w[3]);

/* Returns the point at a place along u, v and the normal of the first sheet's pose [m]. */
void scene_pose_point(const struct scene *scene, const double place[3], double xyz[3]);

/* Tells whether all sheets start in their planes. */
bool scene_starts_flat(const struct scene *scene);

/* Returns where a material point is at the start, without strain unless the sheet is sewn
 * together or put into space [m]. */
void scene_rest_point(const struct scene *scene, const double uvw[3], double xyz[3]);

/* The curved rest shape `cloak`: part of a cone (of a cylinder without flare) as wide as an
 * opening angle around its axis, hung or held by its upper edge.
 *
 * With W the length of the mid-surface's upper edge, alpha the opening, beta the flare
 * (generators against axis) and e_w = e_u x e_v:
 *   X(u,v,w) = origin + z e_u + r (sin phi e_v + cos phi e_w),
 *   r   = W / alpha + u L sin beta + (w - 1/2) h cos beta,
 *   z   =             u L cos beta - (w - 1/2) h sin beta,
 *   phi = 2 atan((2 v - 1) tan(alpha / 4)).
 * So e_u is the axis, `origin` the upper edge's centre, u runs from that edge to the hem
 * along straight generators, v around, w outwards along the normal: parallel surfaces of a
 * cone are cones. phi(v) is the parametrisation of the arc as one rational quadratic (Piegl
 * & Tiller 1997, sec. 7.3), which every NURBS of degree 2 or more in v contains exactly;
 * d phi / d v is 1 / cos(alpha/4)^2 times smaller at the ends than in the middle.
 *
 * With an opening of 360 degrees the cloak is closed, v = 1 is v = 0 again, and phi =
 * (2 v - 1) pi. It is a tube, a skirt or, with a flare of 90 degrees, a flat disc with a
 * hole: the cloth of a drape test without the part that is held, whose rim is the edge
 * u = 0. (A full disc as a patch over a square has four points on its rim at which the
 * sides of the square meet without a corner, and the circle that holds it is no line of the
 * patch; here the hold is an edge, and all places around are alike.)
 */

/* The largest opening [deg] but for 360; d phi / d v then varies 7-fold. */
#define SCENE_CLOAK_MAX_OPENING 270

/* Tells whether the sheet is closed along v. */
bool scene_closed(const struct scene *scene);

/* Returns tan(alpha / 4). */
double scene_cloak_quarter_tangent(const struct scene *scene);

/* Return phi of v [rad], and v of phi, which may lie outside [0,1] unless closed. */
double scene_cloak_angle(const struct scene *scene, double v);
double scene_cloak_across(const struct scene *scene, double phi);

/* Returns radius r and height z at u, w [m]. */
void scene_cloak_meridian(const struct scene *scene, double u, double w, double *r,
                          double *z);

/* Returns the point at height z, r times (along e_v, along e_w) off the axis [m]. */
void scene_cloak_place(const struct scene *scene, double z, double along_v, double along_w,
                       double xyz[3]);

/* Evaluates X(u,v,w) [m]. */
void scene_cloak_point(const struct scene *scene, const double uvw[3], double xyz[3]);

/* Returns the ripple at xyz, one of many for each seed: the sum of 32 waves of the length
 * scene->wave in random directions and phases, with the mean square 1 over all seeds. Waves
 * of a position at rest, so that it is the same for all nets and has no direction of its
 * own. */
double scene_ripple(const struct scene *scene, const double xyz[3]);

/* Tells whether it is there. */
bool scene_ripples(const struct scene *scene);

/* Returns the velocity at t = 0 of the point at xyz [m/s]. */
void scene_initial_velocity(const struct scene *scene, const double xyz[3], double v[3]);

/* Tells whether there is one support alone, which holds the edge u = 0 in x, y, z and
 * rests. */
bool scene_is_cantilever(const struct scene *scene);

/* Tells whether one of the supports, no gripper, holds all of the edge of a sheet where u
 * (i = 0) or v begins, or ends, in x, y, z; it may move. */
bool scene_edge_clamped(const struct scene *scene, int sheet, int i, bool end);

/* Returns the highest speed of the wind, of drag and of air [m/s]. */
double scene_wind_speed(const struct scene *scene);

/* Tells whether all that acts on a flat sheet is the same all across it, along v: it moves
 * as a strip. */
bool scene_same_across(const struct scene *scene);

/* Returns the law of the sheet, by E, nu and h or by its fabric. */
struct law scene_law(const struct scene *scene);

/* Makes the sheet of scene->fabric: thickness, density and the mean of E and nu follow. */
void scene_use_fabric(struct scene *scene);

/* Returns the bending stiffness along u of a wide sheet, D = E h^3 / 12 (1 - nu^2) of an
 * isotropic one [N m]. */
double scene_bending_stiffness(const struct scene *scene);

/* Returns weight over bending, Gamma = rho |g| h L^3 / D [1]. */
double scene_gamma(const struct scene *scene);

/* Gammas up to which small-strain linear theory is within 1 % and 10 % of the tip of a
 * cantilever (heavy elastica), and those of real cloth a metre long. */
#define SCENE_GAMMA_ONE_PERCENT 0.9
#define SCENE_GAMMA_TEN_PERCENT 2.9
#define SCENE_GAMMA_CLOTH       7e4

#endif
