#include "bench/studies/study_ensemble.h"
enum status study_ensemble_tell(const struct study_ensemble *e, const char *folder,
                                enum table_format format, FILE *file, struct message *why)
{
    (void)folder;
    (void)format;
    (void)why;
    for (int n = 0; n < e->count; n++) {
        fprintf(file, "%s %s %s %d %d %s\n", e->name, e->one[n].title, e->one[n].net,
                e->one[n].lived, e->one[n].died, e->one[n].sentence.text);
        for (int t = 0; t < e->fields; t++)
            fprintf(file, "  %.2f %.3g %.3g\n", e->field_time[t], e->one[n].growth[t],
                    e->one[n].points[t]);
    }
    return STATUS_OK;
}
