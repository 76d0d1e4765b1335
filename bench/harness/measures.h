/* measures.h - the numbers that a run is reduced to, computed from its looks (looks.h). */
#ifndef MEASURES_H
#define MEASURES_H

/* Numbers of a run: name, unit, sentence. `Largest` and `end` are of the looks that the run
 * lived to see. A time that did not come is INFINITY; a number that does not exist
 * (penetration without obstacles, the energy of a scheme that has none, anything of a run
 * without looks) is NaN. The three of the truth are read from result files in which a sweep
 * has stored the distances (LOOKS_TRUTH), and a sweep computes that to the reference;
 * elsewhere they are NaN. */
#define MEASURE_LIST(X)                                                                    \
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
    X(THROUGH_MAX, through_max, "1",                                                       \
      "steps that ended with part of an obstacle, thinner than the net, through the "      \
      "sheet")                                                                             \
    X(THROUGH_TIME, through_time, "s", "first look after such a step")                     \
    X(SPREAD_MAX, spread_max, "1",                                                         \
      "largest rms difference of a stretch from its neighbours, a tenth of the sheet "     \
      "away")                                                                              \
    X(TURN_MAX, turn_max, "rad", "largest rms angle by which a cell of the net bends")     \
    X(SPEED_MAX, speed_max, "m/s", "largest rms speed between two looks")                  \
    X(SPEED_END, speed_end, "m/s", "the same between the last two")                        \
    X(ENERGY_DRIFT_MAX, energy_drift_max, "1", "largest share of the energy in play won")  \
    X(ENERGY_DRIFT_END, energy_drift_end, "1", "share won or lost at the end")             \
    X(LOAD_MAX, load_max, "1", "largest share of the weight that obstacles carry")         \
    X(LOAD_END, load_end, "1", "the same, mean over the last tenth of the time")           \
    X(REACTION_MAX, reaction_max, "N", "largest force of the first support")               \
    X(REACTION_END, reaction_end, "N", "the same at the end")                              \
    X(NOT_ARRIVED, not_arrived, "1",                                                       \
      "largest share of a step's loads that iterations left at their limit, or where a "   \
      "chosen number left more than all; 0: none did")                                     \
    X(BLOWUP_TIME, blowup_time, "s", "when the run died")                                  \
    X(END_TIME, end_time, "s", "the last look")                                            \
    X(GAMMA, gamma, "1", "weight against bending, rho g h L^3 / D")                        \
    X(YOUNG_OVER_DENSITY, young_over_density, "m^2/s^2", "E / rho")                        \
    X(HANGING_STRAIN, hanging_strain, "1", "rho g L / E, of a strip that hangs at rest")   \
    X(TRUTH_ERROR_MAX, truth_error_max, "1",                                               \
      "largest rms distance to the scene's known truth, over the length")                  \
    X(TRUTH_ERROR_END, truth_error_end, "1", "the same at the last time of that truth")    \
    X(TRUTH_BAR_END, truth_bar_end, "1", "error bar of the truth then, over the length")   \
    X(REFERENCE_ERROR_MAX, reference_error_max, "1",                                       \
      "largest rms distance to a sweep's reference case, over the rms way of that one")

enum measure {
#define MEASURE_CODE(code, name, unit, sentence) MEASURE_##code,
    MEASURE_LIST(MEASURE_CODE)
#undef MEASURE_CODE
        MEASURES
};

/* Return the words of a measure (enum measure). Static storage. The name behind the last is
 * NULL, with which lists of words end. */
const char *measure_name(int measure);
const char *measure_unit(int measure);
const char *measure_sentence(int measure);

/* Returns the measure of this name; -1: there is none. */
int measure_find(const char *name);

#endif
