#include "bench/verify/checks/verify_plates.h"

#include <stdlib.h>

enum { SIDE = FREEFEM_SIDE, POINTS = VERIFY_PLATES_POINTS };

bool verify_plates_read(struct verify_sheet *sheet, const char *name,
                        struct freefem_field *f)
{
    char *path SCOPED(scope_free) = NULL;
    const bool there =
        verify_sheet_table(sheet, name) &&
        verify_sheet_holds(sheet, reference_path(name, &path, &sheet->why)) &&
        verify_sheet_holds(sheet, freefem_read(path, f, &sheet->why));

    return there;
}

void verify_plates_physics(const struct verify_sheet *sheet, struct settings *all)
{
    const struct reference *table = sheet->table;
    static const char *const sizes[] = {"length", "width", "thickness"};
    static const char *const material[] = {"young", "poisson", "density"};

    for (int n = 0; n < 6; n++) {
        const char *key = n < 3 ? sizes[n] : material[n - 3];
        if (reference_note(table, key))
            settings_print(all, "%s.%s=%.17g", n < 3 ? "sheet" : "material", key,
                           reference_note_number(table, key));
    }
    if (reference_note(table, "gravity"))
        settings_print(all, "gravity=[0,0,%.17g]",
                       -reference_note_number(table, "gravity"));
}

const double *verify_plates_points(void)
{
    static double uvw[POINTS][3];

    for (int n = 0; n < POINTS; n++) {
        uvw[n][0] = n % SIDE / (SIDE - 1.0), uvw[n][1] = n / SIDE / (SIDE - 1.0);
        uvw[n][2] = 0.5;
    }
    return uvw[0];
}

double verify_plates_error(const struct freefem_field *f, int time, const double (*xyz)[3],
                           double scale, double *bar)
{
    struct freefem_field still = {0}, ours = {0};
    double *shift = ours.shift[time][0][0];
    const double *uvw = verify_plates_points();

    for (int n = 0; n < 3 * POINTS; n++)
        shift[n] = scale * (xyz[n / 3][n % 3] - (n % 3 < 2 ? uvw[n] : 0));
    const double moved = freefem_difference(&still, f, time);
    *bar = f->error[time] / moved;
    return freefem_difference(&ours, f, time) / moved;
}
