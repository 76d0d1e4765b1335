/* case.h - one run reduced to numbers: the unit of sweeps and of Table 4.
 *
 * A run is looked at after every few frames, at the scene's snapshots and at its end. A
 * look is the metrics of that moment; the measures below are read off the looks. They are
 * the same doubles on every run of a plan; seconds stand apart.
 */
#ifndef CASE_H
#define CASE_H

#include <stdbool.h>

#include "bench/files/provenance.h"
#include "models/status.h"

/* name, unit, sentence. `Largest` and `end` are of the looks that the run lived to see. A
 * time that did not come is INFINITY; a number that does not exist (penetration without
 * obstacles, the energy of a scheme that has none, anything of a run without looks) is NaN.
 */
#define CASE_MEASURE_LIST(X)                                                               \
    X(STRETCH_MAX, stretch_max, "1", "largest principal stretch of the mid-surface")       \
    X(STRETCH_END, stretch_end, "1", "the same at the end")                                \
    X(DROP_MAX, drop_max, "1", "lowest point below the support, over the length")          \
    X(DROP_END, drop_end, "1", "the same at the end")                                      \
    X(ANGLE_MAX, angle_max, "degrees", "largest angle of the middle line below level")     \
    X(ANGLE_END, angle_end, "degrees", "the same at the end")                              \
    X(ROUGHNESS_MAX, roughness_max, "1", "largest rms curvature, times the length")        \
    X(ROUGHNESS_END, roughness_end, "1", "the same at the end")                            \
    X(PENETRATION_MAX, penetration_max, "m", "largest depth below an obstacle")            \
    X(INTERSECTIONS_MAX, intersections_max, "1", "most pairs of triangles that cross")     \
    X(INTERSECTIONS_END, intersections_end, "1", "the same at the end")                    \
    X(INTERSECTION_TIME, intersection_time, "s",                                           \
      "first look at which the sheet crosses"                                              \
      " itself")                                                                           \
    X(SPEED_MAX, speed_max, "m/s", "largest rms speed between two looks")                  \
    X(SPEED_END, speed_end, "m/s", "the same between the last two")                        \
    X(ENERGY_DRIFT_MAX, energy_drift_max, "1", "largest share of the energy in play won")  \
    X(ENERGY_DRIFT_END, energy_drift_end, "1", "share won or lost at the end")             \
    X(BLOWUP_TIME, blowup_time, "s", "when the run died")                                  \
    X(END_TIME, end_time, "s", "the last look")                                            \
    X(GAMMA, gamma, "1", "weight against bending, rho g h L^3 / D")                        \
    X(YOUNG_OVER_DENSITY, young_over_density, "m^2/s^2", "E / rho")                        \
    X(HANGING_STRAIN, hanging_strain, "1", "rho g L / E, of a strip that hangs at rest")

enum case_measure {
#define CASE_MEASURE_CODE(code, name, unit, sentence) CASE_##code,
    CASE_MEASURE_LIST(CASE_MEASURE_CODE)
#undef CASE_MEASURE_CODE
        CASE_MEASURES
};

/* Words for them; "unknown" beyond the last. Static storage. */
const char *case_measure_name(int measure);
const char *case_measure_unit(int measure);
const char *case_measure_sentence(int measure);

struct case_plan {    /* all borrowed */
    const char *path; /* scene file                                                    */
    int setting_count;
    const char *const *settings; /* the last ones win                                  */
    const char *model;
    int every;          /* frames between looks, >= 1                                  */
    bool intersections; /* count self-intersections, by metric_intersections_every     */
    bool snapshots;     /* keep the fields at the scene's snapshots                    */
    const char *out;    /* result file (store.h); NULL: none                           */
    const struct provenance *provenance; /* goes into the file; NULL: as things stand  */
};

struct case_result {
    enum status outcome;     /* STATUS_OK, a death, or STATUS_UNSUPPORTED               */
    struct message sentence; /* "done", or what it died of, or what the model leaves out */
    double value[CASE_MEASURES];
    double create_seconds, step_seconds, look_seconds;
};

/* Runs it. A death is a result, and so is a model that leaves out what the scene needs; the
 * file of such a case has no frames. The same bits with and without file, snapshots kept or
 * not. STATUS_INPUT: scene, settings, model or discretization are impossible; STATUS_FILE;
 * STATUS_MEMORY; no file then. */
enum status case_run(const struct case_plan *plan, struct case_result *result,
                     struct message *why);

/* The same result, bit for bit, from the file of a run. STATUS_FILE, STATUS_INPUT: the file
 * cannot be read or is not that of a case. */
enum status case_read(const char *path, struct case_result *result, struct message *why);

#endif
