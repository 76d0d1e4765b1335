/* Each kind of a scene's damping is a rate on masses and stiffness, or a factor. */
#include "models/damping.h"

#include "tests/check.h"

int main(void)
{
    static const struct {
        enum damping_kind kind;
        double mass, stiffness, velocity;
    } rows[] = {{DAMPING_NONE, 0, 0, 1},
                {DAMPING_VELOCITY_SCALE, 0, 0, 0.4},
                {DAMPING_VELOCITY_RATE, 0, 0, 1 - 0.4 * 0.02},
                {DAMPING_MASS, 0.4, 0, 1},
                {DAMPING_RAYLEIGH, 3, 0.07, 1}};

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        const struct scene s = {
            .density = 5,
            .drag = 2,
            .step = 0.02,
            .damping = {.kind = rows[n].kind, .value = 0.4, .alpha = 3, .beta = 0.07}};
        CHECK(damping_mass(&s) == rows[n].mass);
        CHECK(damping_stiffness(&s) == rows[n].stiffness);
        CHECK(damping_velocity(&s) == rows[n].velocity);
        CHECK(damping_drag(&s) == 0.4);
        CHECK(damping_words[rows[n].kind] != NULL);
    }
    CHECK(damping_words[sizeof rows / sizeof *rows] == NULL);
    return check_result();
}
