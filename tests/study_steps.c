/* What study timestep says of made-up results: every sentence in every turn that it can
 * take, with its numbers; and what its tables and files have.
 *
 *   study_steps FOLDER
 */
#include "bench/studies/studies.h"
#include "bench/studies/study_timestep.h"
#include "tests/study_fixture.h"

#define TURNS(list) sizeof(list) / sizeof *(list), list

enum { LAST = STUDY_TIMESTEP_TIMES - 1, LEVELS = STUDY_TIMESTEP_LEVELS };

/* --- Flat sheets, kept until the end. */

static double *flats[128];
static int flat_count;

static double *flat(double depth)
{
    double *xyz = calloc(3 * GRID_POINTS, sizeof *xyz);

    REQUIRE(xyz && flat_count < 128);
    for (int n = 0; n < GRID_POINTS; n++)
        xyz[3 * n + 2] = -depth;
    return flats[flat_count++] = xyz;
}

/* Of fall_printed, fall_incremental, creep and creep_static, by level and time; and the
 * motions of two schemes at the last time. */
static double *sunk[4][STUDY_TIMESTEP_FALLS][3], *same, *near, *far;

static double acceleration(const struct study_row *row)
{
    const double mu = row->run.scene.damping.value;

    return (1 + mu) / (2 * (1 - mu)); /* g = 1 */
}

/* A thousandth more than in theory; of the creep two. */
static void drop_sheets(struct study_made *m)
{
    const struct study *printed = study_of(m, "fall_printed"),
                       *creep = study_of(m, "creep");

    for (int n = 0; n < STUDY_TIMESTEP_FALLS; n++)
        for (int t = 0; t < 3; t++) {
            const double a = acceleration(&printed->row[n]), s = printed->time[t];
            const double step = printed->row[n].run.scene.step;
            sunk[0][n][t] = flat(1.001 * a * s * s / 2 + 0.3 * s + 0.1);
            sunk[1][n][t] = flat(1.003 * a * step * s + 0.1);
        }
    for (int n = 0; n < STUDY_TIMESTEP_CREEPS; n++) {
        const double sag = 4e5 / creep->row[n].run.scene.young;
        for (int t = 0; t < 2; t++)
            sunk[2][n][t] =
                flat(1.002 * sag / creep->row[n].run.scene.step * creep->time[t]);
        sunk[3][n][0] = flat(sag);
    }
    same = flat(0.5), near = flat(0.5002), far = flat(0.5006);
}

static struct study_row *row_of(struct study_made *m, enum study_timestep_kind kind, int n)
{
    return &m->r.study[kind].row[n];
}

/* All live but the printed scheme with mass damping, which dies sooner at shorter steps. */
static void steps(struct study_made *m)
{
    static const char *const name[] = {"fall_printed", "fall_incremental", "creep",
                                       "creep_static"};
    static const double next[] = {0.25, 0.5, 0.9, 0.3, 1, 1.1, 1.5}; /* exponents */

    for (int k = 0; k < 4; k++) {
        struct study *s = study_of(m, name[k]);
        for (int n = 0; n < s->plan->level_count; n++)
            for (int t = 0; t < s->frames; t++)
                s->row[n].frame[t].xyz = sunk[k][n][t];
    }
    for (enum study_timestep_kind k = 0; k < STUDY_TIMESTEP_KINDS; k++)
        for (int n = 0; n < LEVELS; n++) {
            struct study_row *row = row_of(m, k, n);
            row->frame[LAST].xyz = k == STUDY_TIMESTEP_PAPER_MASS ? NULL : same;
            row->frame[LAST].next =
                n < LEVELS - 1 ? 0.02 * pow(row->level->size / 0.01, next[k]) : NAN;
            if (k == STUDY_TIMESTEP_PAPER_MASS)
                row->result.outcome = STATUS_DIVERGED, row->frame[LAST].next = NAN,
                row->result.death_time = 0.3 - n / 50.;
            if (k == STUDY_TIMESTEP_SHEET)
                row->frame[LAST].drop = 6.4 * row->level->size;
            if (k == STUDY_TIMESTEP_INCREMENT)
                row->frame[LAST].drop = 2 * pow(row->level->size, 0.9);
        }
    row_of(m, STUDY_TIMESTEP_SHEET_RATE, LEVELS - 2)->frame[LAST].next = 1.2e-4;
    row_of(m, STUDY_TIMESTEP_SHEET_MASS, LEVELS - 1)->frame[LAST].xyz = near;
}

/* Every drop and halving as if the step did nothing, nobody dead. */
static void all_settle(struct study_made *m)
{
    for (int n = 0; n < LEVELS; n++) {
        struct study_row *dead = row_of(m, STUDY_TIMESTEP_PAPER_MASS, n);
        dead->frame[LAST].xyz = same, dead->result.death_time = NAN;
        row_of(m, STUDY_TIMESTEP_SHEET, n)->frame[LAST].drop = 0.8;
        row_of(m, STUDY_TIMESTEP_PAPER, n)->frame[LAST].next =
            row_of(m, STUDY_TIMESTEP_SHEET, n)->frame[LAST].next;
        row_of(m, STUDY_TIMESTEP_INCREMENT_MASS, n)->frame[LAST].next =
            row_of(m, STUDY_TIMESTEP_SHEET, n)->frame[LAST].next;
    }
}

/* The other way about; the mass-damped sheet converges with a limit of its own. */
static void none_settles(struct study_made *m)
{
    row_of(m, STUDY_TIMESTEP_SHEET_MASS, LEVELS - 1)->frame[LAST].xyz = far;
    for (int n = 0; n < LEVELS; n++)
        row_of(m, STUDY_TIMESTEP_SHEET_MASS, n)->frame[LAST].next =
            row_of(m, STUDY_TIMESTEP_INCREMENT_MASS, n)->frame[LAST].next;
    row_of(m, STUDY_TIMESTEP_PAPER_MASS, 1)->result.death_time = 0.31;
    study_of(m, "fall_printed")->row[5].frame[1].xyz = sunk[0][6][1];
}

static void creeps_slowly(struct study_made *m)
{
    study_of(m, "creep")->row[4].frame[0].xyz = sunk[2][4][1];
}

/* Where something died that never should. */
static void all_die(struct study_made *m)
{
    for (enum study_timestep_kind k = 0; k < STUDY_TIMESTEP_KINDS; k++)
        for (int n = 0; n < LEVELS; n++) {
            struct study_frame *f = &row_of(m, k, n)->frame[LAST];
            f->xyz = NULL, f->drop = f->next = f->stretch = NAN;
        }
    study_of(m, "fall_printed")->row[3].frame[0].xyz = NULL;
}

static void two_die(struct study_made *m)
{
    for (int n = 0; n < 3; n++)
        row_of(m, STUDY_TIMESTEP_PAPER_MASS, n)->frame[LAST].xyz = same;
}

#define SCALE "- \"one damping coefficient mu limits the velocity, v <- mu v\": "
#define PAPER                                                                              \
    "- \"implicit integration does not depend on the time step (the printed scheme)\": "
#define STABLE "- \"implicit integration is unconditionally stable\": "

static const struct study_turn turns[] = {
    {.want = "printed, v <- 0.5 v 5.00 11.0 1.10 7.100 7.110 7.120 7.130 6.130 1.68 "},
    {.want = "printed, v <- 0.5 v 2.00 1.19 0.250 printed, C = 2 M - - - "},
    {.want = "0.700 2.50 2.8362 2.8333 1.00100 0.0071046 0.0070833 1.00300 "},
    {.want = "4.00e+07 10.0 1.0020 0.010000 1.00200 4.0080e+05 "},
    {.want = "What the step does " SCALE
             "does not hold. As a property of the cloth it would not depend on the "
             "step. An elastic sheet (nonlinear) drops 0.064 L by 0.4 s at 10 ms and "
             "0.0040 L at 0.625 ms, as dt^1.00; the incremental one as dt^0.90: the "
             "shorter the step, the stiffer the air, and in the limit nothing moves. " PAPER
             "does not hold. Halving the step moves the sheet by 2, 1.7, 1.4 and 1.2 "
             "% of L at 0.4 s, as dt^0.25; its largest stretch is 6.030, 6.130, "
             "6.230, 6.330 and 6.430 from 10 to 0.625 ms. A viscosity E dt changes "
             "with the step, and goes to nothing. " STABLE
             "does not hold. With mass damping instead of v <- mu v the printed "
             "scheme dies at 5 of 5 steps, sooner at shorter ones (above): its d, "
             "never reset, is added to the sheet again every step, and only the "
             "scaling of v keeps it down."},
    {.want =
         "- The printed sheet is viscous. A free one falls with g (1 + mu) / (2 (1 - "
         "mu)) to 1.0e-03, whatever the step; a loaded cantilever creeps by its elastic "
         "sag every step to 2.0e-03, so that its speed goes as (E dt)^-1.000. - An "
         "elastic sheet with a damping that is a rate has a limit: v <- (1 - 2 dt) v "
         "has order 2.32, C = 2 M order 1.50, and their motions are the same: at 0.625 "
         "ms they are 0.01 % of L apart. - incremental with C = 2 M forgets its strain "
         "every step, a viscosity E dt again: halving the step changes its motion as "
         "dt^0.30, no limit in sight, and its stretch at 0.4 s goes from 24.120 at 10 "
         "ms to 25.720 at 0.625 ms."},
    {.change = all_settle, .want = SCALE "holds. As a property"},
    {.change = all_settle, .want = "as dt^0.00; the incremental one as dt^0.90. "},
    {.change = all_settle,
     .want = PAPER "holds. Halving the step moves the sheet by 2, 1, "},
    {.change = all_settle, .want = "6.330 and 6.430 from 10 to 0.625 ms. " STABLE},
    {.change = all_settle,
     .want = STABLE "holds. With mass damping instead of v <- mu v the printed scheme dies "
                    "at 0 of 5 steps. "},
    {.change = all_settle,
     .want = "halving the step changes its motion as dt^1.00, so it has a limit, and its "},
    {.change = none_settles, .want = "dies at 5 of 5 steps: its d, never reset"},
    {.change = none_settles,
     .want = "a rate has no limit in sight: v <- (1 - 2 dt) v has "},
    {.change = none_settles,
     .want = "C = 2 M order 0.30, and their motions are not the same: at 0.625 ms they are "
             "0.03 % of L apart."},
    {.change = none_settles, .want = "- The printed sheet is not viscous. A free one"},
    {.change = creeps_slowly, .want = "- The printed sheet is not viscous. A free one"},
    {.change = two_die, .want = STABLE "does not hold. With"},
    {.change = two_die, .want = "the printed scheme dies at 2 of 5 steps"},
    {.change = all_die, .want = SCALE "cannot be judged. As a property"},
    {.change = all_die, .want = PAPER "cannot be judged. Halving"},
    {.change = all_die, .want = "- The printed sheet may be viscous. A free one falls"},
    {.change = all_die,
     .want = "a rate has a limit or not: v <- (1 - 2 dt) v has order nan"},
    {.change = all_die,
     .want = "their motions cannot be compared: at 0.625 ms they are nan"},
    {.change = all_die, .want = "changes its motion as dt^nan, which tells nothing, and"},
};

static void tables(struct study_made *m)
{
    static const char motion[] =
        "scheme,step_ms,a_frame_ms,stepping_s,drop_0_1_s_over_length,0_2_s_over_length,"
        "0_3_s_over_length,0_4_s_over_length,stretch_0_4_s,to_next_step_over_length_"
        "percent";
    static const char limits[] = "scheme,largest_difference_over_length_percent,"
                                 "smallest_over_length_percent,exponent_of_dt";
    static const char falls[] =
        "mu,step_ms,printed_m_per_s2,g_1_mu_per_2_1_mu__m_per_s2,ratio,incremental_m_per_s,"
        "that_dt_m_per_s,ratio_2";
    static const char creeps[] = "e_pa,step_ms,tip_s_speed_m_per_s,static_sag_m,"
                                 "speed_dt_per_sag,speed_e_dt_pa_m";
    static const char file[] =
        "scheme,step_s,time_s,drop,stretch,rmse_to_next_over_length,frame_ms";

    study_fill(m);
    snprintf(row_of(m, STUDY_TIMESTEP_PAPER_MASS, 2)->result.sentence.text, 64,
             "died, too");
    char *text = study_told(&study_timestep_experiment, m, TABLE_CSV);
    STUDY_ROW(text, motion, "\"printed, v <- 0.5 v\"", 1, 5, 11, 1.1, 7.1, 7.11, 7.12, 7.13,
              6.13, 2 * pow(2, -0.25));
    STUDY_ROW(text, motion, "\"nonlinear, v <- 0.5 v\"", 0, 10, 50, 5, 35, 35.05, 35.1,
              0.064, 30.15, 2);
    STUDY_ROW(text, limits, "\"printed, v <- 0.5 v\"", 0, 2, 2 * pow(8, -0.25), 0.25);
    STUDY_ROW(text, limits, "\"printed, C = 2 M\"", 0, NAN, NAN, NAN);
    STUDY_ROW(text, falls, "0.20000000000000001", 0, 10, 1.001 * 0.75, 0.75, 1.001);
    STUDY_ROW(text, creeps, "40000000", 0, 10, 1.002 * 0.01 / 0.01, 0.01, 1.002);
    STUDY_ROW(text, creeps, "80000000", 0, 5, 1.002 * 0.005 / 5e-3, 0.005, 1.002);
    STUDY_ROW(text, falls, "0.69999999999999996", 1, 2.5, 1.001 * 1.7 / 0.6, 1.7 / 0.6,
              1.001, 1.003 * 1.7 / 0.6 * 2.5e-3, 1.7 / 0.6 * 2.5e-3, 1.003);
    STUDY_ROW(text, creeps, "20000000", 0, 5, 1.002 * 0.02 / 5e-3, 0.02, 1.002,
              1.002 * 0.02 * 2e7);
    study_wants(text, "# printed, C = 2 M, step 2.5 ms: died, too.");
    study_wants(text, "# IGA 10x10x2, (2,2,1). drop: lowest point");
    study_wants(text, "# A motion with a limit of order e");
    study_wants(text, "# From positions at 0.5, 0.75 and 1 s: printed falls");
    study_wants(text, "# h = 20 mm, mu = 0.5, gravity 0.1 m/s^2");
    free(text);
    text = study_file("timestep.csv");
    STUDY_ROW(text, file, "\"printed, v <- 0.5 v\"", 5, 0.01, 0.2, 7.01, 6.01, 1.01, 10);
    STUDY_ROW(text, file, "\"nonlinear, C = 2 M\"", 18, 0.00125, 0.4, 7 * 7.33, 7 * 6.33,
              0.02 * pow(0.125, 1.5), 73);
    free(text);
    study_wants_file("timestep.gp", "10 7.03 5 7.13 2.5 7.23 1.25 7.33 0.625 7.43 EOD");
    study_wants_file("timestep.gp", "10 0.02 5 0.01 2.5 0.005 1.25 0.0025 EOD");
    study_wants_file("timestep.gp", "set xlabel 'step [ms]'");
    study_wants_file("timestep.gp",
                     "set xtics ('0.625' 0.625,'1.25' 1.25,'2.5' 2.5,'5' 5,'10' 10)");
    study_wants_file("timestep.gp", "set ylabel 'RMSE / L to half the step'");
    free(study_file("nonlinear_mass.csv"));
    text = study_squeeze(study_file("timestep.gp"));
    CHECK(!strstr(text, "'printed, C = 2 M'")); /* which does not live */
    free(text);
}

int main(int count, char **arguments)
{
    struct study_made m;

    study_begin(count, arguments);
    study_make(&m, "timestep", NULL);
    drop_sheets(&m);
    m.base = steps;
    study_turns(&study_timestep_experiment, &m, TURNS(turns));
    tables(&m);
    study_unmake(&m);
    for (int n = 0; n < flat_count; n++)
        free(flats[n]);
    return check_result();
}
