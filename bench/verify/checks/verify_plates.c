#include "bench/verify/checks/verify_plates.h"

#include <math.h>
#include <stdlib.h>

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
    static const char *const key[][2] = {
        {"length", "sheet.length"},      {"width", "sheet.width"},
        {"young", "material.young"},     {"poisson", "material.poisson"},
        {"density", "material.density"}, {"thickness", "sheet.thickness"}};

    for (int n = 0; n < (int)(sizeof key / sizeof *key); n++)
        if (reference_note(table, key[n][0]))
            settings_number(all, key[n][1], truth_table_note(table, key[n][0]));
    if (reference_note(table, "gravity"))
        settings_numbers(all, "gravity", 3,
                         (double[]){0, 0, -truth_table_note(table, "gravity")});
}

void verify_plates_points(double uvw[POINTS][3])
{
    for (int n = 0; n < POINTS; n++) {
        uvw[n][0] = n % SIDE / (SIDE - 1.0), uvw[n][1] = n / SIDE / (SIDE - 1.0);
        uvw[n][2] = 0.5;
    }
}

double verify_plates_apart(const struct freefem_field *f, int time, const double (*xyz)[3],
                           double scale)
{
    const double *shift = f->shift[time][0][0];
    double uvw[POINTS][3], sum = 0;

    verify_plates_points(uvw);
    for (int n = 0; n < POINTS; n++)
        for (int i = 0; i < 3; i++) {
            double moved = xyz[n][i] - (i < 2 ? uvw[n][i] : 0);
            sum += pow(moved * scale - shift[3 * n + i], 2);
        }
    return sum;
}

double verify_plates_moved(const struct freefem_field *f, int time)
{
    double still[POINTS][3];

    verify_plates_points(still);
    for (int n = 0; n < POINTS; n++)
        still[n][2] = 0;
    return verify_plates_apart(f, time, still, 1);
}
