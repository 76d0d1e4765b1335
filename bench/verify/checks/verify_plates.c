#include "bench/verify/checks/verify_plates.h"

#include <stdlib.h>
#include <string.h>

enum { SIDE = FREEFEM_SIDE, POINTS = VERIFY_PLATES_POINTS };

bool verify_plates_read(struct verify_sheet *sheet, const char *name,
                        struct freefem_field *f)
{
    char *path = NULL;
    const bool there =
        verify_sheet_table(sheet, name) &&
        verify_sheet_holds(sheet, truth_table_path(name, &path, &sheet->why)) &&
        verify_sheet_holds(sheet, freefem_read(path, f, &sheet->why));

    free(path);
    return there;
}

void verify_plates_physics(const struct verify_sheet *sheet, struct settings *all)
{
    const struct reference *table = sheet->table;
    static const char *const keys[] = {"sheet.length",
                                       "sheet.width",
                                       "sheet.thickness",
                                       "material.young",
                                       "material.poisson",
                                       "material.density",
                                       NULL};

    for (int n = 0; keys[n]; n++)
        if (reference_note(table, strchr(keys[n], '.') + 1))
            settings_number(all, keys[n],
                            truth_table_note(table, strchr(keys[n], '.') + 1));
    if (reference_note(table, "gravity"))
        settings_print(all, "gravity=[0,0,%.17g]", -truth_table_note(table, "gravity"));
}

void verify_plates_points(double uvw[POINTS][3])
{
    for (int n = 0; n < POINTS; n++) {
        uvw[n][0] = n % SIDE / (SIDE - 1.0), uvw[n][1] = n / SIDE / (SIDE - 1.0);
        uvw[n][2] = 0.5;
    }
}

double verify_plates_error(const struct freefem_field *f, int time, const double (*xyz)[3],
                           double scale, double *bar)
{
    struct freefem_field still = {0}, ours = {0};
    double *shift = ours.shift[time][0][0], uvw[POINTS][3];

    verify_plates_points(uvw);
    for (int n = 0; n < 3 * POINTS; n++)
        shift[n] = scale * (xyz[n / 3][n % 3] - (n % 3 < 2 ? uvw[n / 3][n % 3] : 0));
    const double moved = freefem_difference(&still, f, time);
    *bar = f->error[time] / moved;
    return freefem_difference(&ours, f, time) / moved;
}
