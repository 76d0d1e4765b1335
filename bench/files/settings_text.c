#include "bench/files/settings_text.h"

#include <stdio.h>
#include <stdlib.h>

static void print_integers(FILE *out, const char *key, const int value[3])
{
    fprintf(out, "discretization.%s=[%d,%d,%d]\n", key, value[0], value[1], value[2]);
}

static void print_doubles(FILE *out, const double *value, int count)
{
    fputc('[', out);
    for (int i = 0; i < count; i++)
        fprintf(out, "%s%.17g", i ? "," : "", value[i]);
    fputc(']', out);
}

/* Keys of the models that are no solids; those not set are the model's own. */
static void print_steps(const struct discretization *d, FILE *out)
{
    fprintf(out, "discretization.parameters=%s\n", parameters_name(d->parameters));
    fprintf(out, "discretization.integrator=%s\n", integrator_name(d->integrator));
    fprintf(out, "discretization.substeps=%d\n", d->substeps);
    fprintf(out, "discretization.iterations=%d\n", d->iterations);
    fprintf(out, "discretization.tolerance=%.17g\n", d->tolerance);
    fprintf(out, "discretization.strain_limit=%.17g\n", d->strain_limit);
    fprintf(out, "discretization.constraint=%s\n", constraint_name(d->constraint));
    fprintf(out, "discretization.acceleration=%s\n", acceleration_name(d->acceleration));
}

enum status settings_text(const struct discretization *d, char **text)
{
    static const char *const direction[3] = {"u", "v", "w"};
    size_t size = 0;
    char *result = NULL;
    FILE *out = open_memstream(&result, &size);

    if (!out)
        return STATUS_MEMORY;
    print_integers(out, "points", d->points);
    print_integers(out, "degree", d->degree);
    print_integers(out, "gauss", d->gauss);
    for (int i = 0; i < 3; i++)
        if (d->knots[i]) {
            fprintf(out, "discretization.knots_%s=", direction[i]);
            print_doubles(out, d->knots[i], d->knot_count[i]);
            fputc('\n', out);
        }
    if (d->weights) {
        fputs("discretization.weights=", out);
        print_doubles(out, d->weights, d->weight_count);
        fputc('\n', out);
    }
    fprintf(out, "discretization.kinematics=%s\n", kinematics_name(d->kinematics));
    fprintf(out, "discretization.remedy=%s\n", remedy_name(d->remedy));
    fprintf(out, "discretization.unknowns=%s\n", unknowns_name(d->unknowns));
    fprintf(out, "discretization.solver=%s\n", solver_name(d->solver));
    print_steps(d, out);
    if (fclose(out) != 0) {
        free(result);
        return STATUS_MEMORY;
    }
    *text = result;
    return STATUS_OK;
}
