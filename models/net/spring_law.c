#include "models/net/spring_law.h"

#include <math.h>

static const double PAPER_STIFFNESS = 100, PAPER_DRAG = 0.05, PAPER_AREA_MASS = 1;

/* The geometry of a cell's diagonal. */
struct diagonal {
    double length, c2, s2; /* squares of cosine and sine to u */
};

static struct diagonal diagonal_of(const double cell[2])
{
    double l2 = cell[0] * cell[0] + cell[1] * cell[1];

    return (struct diagonal){sqrt(l2), cell[0] * cell[0] / l2, cell[1] * cell[1] / l2};
}

struct spring_law_stiffness spring_law_effective(const struct spring_law *law,
                                                 const double cell[2])
{
    struct diagonal d = diagonal_of(cell);
    double q =
        2 * law->stiffness[SPRING_DIAGONAL] * d.length * d.length / (cell[0] * cell[1]);

    return (struct spring_law_stiffness){
        .c11 = law->stiffness[SPRING_U] * cell[0] / cell[1] + q * d.c2 * d.c2,
        .c22 = law->stiffness[SPRING_V] * cell[1] / cell[0] + q * d.s2 * d.s2,
        .c12 = q * d.c2 * d.s2,
        .c33 = q * d.c2 * d.s2,
    };
}

/* Returns P of hinges of length a and width b with the bending stiffness B per width: the
 * energy of one is P a theta^2 / 4 = B (theta / a)^2 a b / 2. */
static double strut_force(double B, double a, double b)
{
    return 2 * B * b / (a * a);
}

/* Stiffness along u and v, and q of the diagonals, that amount to a sheet's. */
struct share {
    double u, v, q;
};

static struct share share_of(struct spring_law_stiffness want, struct diagonal d)
{
    double q = want.c33 / (d.c2 * d.s2);

    q = fmin(q, fmin(want.c11 / (d.c2 * d.c2), want.c22 / (d.s2 * d.s2)));
    return (struct share){fmax(want.c11 - q * d.c2 * d.c2, 0),
                          fmax(want.c22 - q * d.s2 * d.s2, 0), q};
}

static struct spring_law_stiffness stiffness_of(const struct law *law, enum law_part part)
{
    const double *m = law->matrix[part];

    return (struct spring_law_stiffness){m[LAW_11], m[LAW_22], m[LAW_12], m[LAW_33]};
}

struct spring_law_stiffness spring_law_plane_stress(const struct scene *scene)
{
    const struct law law = scene_law(scene);

    return stiffness_of(&law, LAW_MEMBRANE);
}

/* Returns what there is against tension along u, with free sides. */
static double along_u(struct spring_law_stiffness c)
{
    return c.c11 - c.c12 * c.c12 / c.c22;
}

static double along_v(struct spring_law_stiffness c)
{
    return c.c22 - c.c12 * c.c12 / c.c11;
}

/* Springs along u and along v keep this share of what they and the diagonals have together
 * (the head's derivation): nets that are pulled to 1.5 times their length stay even. */
static const double KEPT = 0.4;

/* Returns the C12 at which springs along u have no more than they keep, from what there is
 * against tension along u and across it, and (a_v / a_u)^2. */
static double most_c12(double E1, double E2, double r2)
{
    const double r = (1 - KEPT) * r2, left = 1 - r * r * E1 / E2;

    return left > 0 ? r * E1 / left : INFINITY;
}

/* Returns the C11 and C22 with which springs of this C33, or the most that these diagonals
 * allow, give way to tension along u or v, with free sides, as the sheet does (the head's
 * derivation). */
static struct spring_law_stiffness freed(struct spring_law_stiffness sheet,
                                         struct diagonal d)
{
    const double E1 = along_u(sheet), E2 = along_v(sheet), r = d.s2 / d.c2;

    sheet.c33 = fmin(sheet.c33, fmin(most_c12(E1, E2, r), most_c12(E2, E1, 1 / r)));
    sheet.c12 = sheet.c33;
    sheet.c11 = (E1 + sqrt(E1 * E1 + 4 * sheet.c12 * sheet.c12 * E1 / E2)) / 2;
    sheet.c22 = sheet.c11 * E2 / E1;
    return sheet;
}

static void match(const struct scene *scene, const double cell[2], struct spring_law *law)
{
    const struct law sheet = scene_law(scene);
    const struct spring_law_stiffness rim = stiffness_of(&sheet, LAW_BENDING);
    const struct diagonal d = diagonal_of(cell);
    const struct share pull = share_of(freed(stiffness_of(&sheet, LAW_MEMBRANE), d), d),
                       turn = share_of(rim, d);
    const double area = cell[0] * cell[1];

    law->stiffness[SPRING_U] = pull.u * cell[1] / cell[0];
    law->stiffness[SPRING_V] = pull.v * cell[0] / cell[1];
    law->stiffness[SPRING_DIAGONAL] = pull.q / 2 * area / (d.length * d.length);
    law->strut[SPRING_U] = strut_force(turn.u, cell[0], cell[1]);
    law->strut[SPRING_V] = strut_force(turn.v, cell[1], cell[0]);
    law->rim_strut[SPRING_U] = strut_force(rim.c11, cell[0], cell[1]) / 2;
    law->rim_strut[SPRING_V] = strut_force(rim.c22, cell[1], cell[0]) / 2;
    law->strut[SPRING_DIAGONAL] = strut_force(turn.q / 2, d.length, area / d.length);
}

double spring_law_mass(const struct scene *scene, enum parameters parameters)
{
    return parameters == PARAMETERS_PAPER ? PAPER_AREA_MASS
                                          : scene->density * scene->thickness;
}

double spring_law_drag(enum parameters parameters)
{
    return parameters == PARAMETERS_PAPER ? PAPER_DRAG : 0;
}

void spring_law_make(const struct scene *scene, enum parameters parameters,
                     const double cell[2], struct spring_law *law)
{
    *law = (struct spring_law){.rim = 1};
    if (parameters == PARAMETERS_PAPER) {
        for (int n = 0; n < SPRING_DIRECTIONS; n++)
            law->stiffness[n] = PAPER_STIFFNESS;
        return;
    }
    law->rim = 0.5;
    match(scene, cell, law);
}

void spring_law_tell(const struct spring_law *law, const double cell[2],
                     const struct scene *scene, struct message *line)
{
    struct spring_law_stiffness net = spring_law_effective(law, cell);
    struct spring_law_stiffness sheet = spring_law_plane_stress(scene);

    status_fail(
        line, STATUS_OK,
        "under tension along u and v, with free sides, the net gives way %.4g and %.4g "
        "times as much as the sheet, in shear %.4g times, held at the sides %.4g and %.4g "
        "times; it narrows by %.4g of a stretch for %.4g (springs have C12 = C33, %s)%s",
        along_u(sheet) / along_u(net), along_v(sheet) / along_v(net), sheet.c33 / net.c33,
        sheet.c11 / net.c11, sheet.c22 / net.c22, net.c12 / net.c22, sheet.c12 / sheet.c22,
        scene->is_fabric ? "not a fabric's Y12" : "plane stress only at nu = 1/3",
        law->rim == 1 /* the paper's */
            ? "; the paper's springs: no bending, own mass and damping, not the scene's"
            : "");
}
