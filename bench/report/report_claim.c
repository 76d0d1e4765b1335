#include "bench/report/report_claim.h"

#include <string.h>

#include "bench/experiment/kept.h"
#include "bench/report/report_json.h"

static void write(FILE *file, struct report_tally *tally, const struct report_part *part,
                  const char *claim, const char *verdict, const char *text, bool quick)
{
    fputs(tally->all++ ? ",{" : "{", file);
    report_json_pair(file, "part", part->id);
    report_json_pair(file, "claim", claim);
    report_json_pair(file, "verdict", verdict);
    report_json_pair(file, "text", text);
    fprintf(file, "\"quick\":%s}", quick ? "true" : "false");
    tally->hold += !strcmp(verdict, "holds");
    tally->fail += !strcmp(verdict, "does not hold");
}

/* Writes the claims that the command itself judged; returns how many. */
static int write_kept(FILE *file, struct report_tally *tally,
                      const struct report_part *part, const struct report_found *found)
{
    const struct csv_table *t = report_part_table(found, KEPT_SENTENCES);

    for (int n = 0; t && n < t->rows; n++)
        write(file, tally, part, csv_words(t, n, csv_column(t, "claim")),
              csv_words(t, n, csv_column(t, "verdict")),
              csv_words(t, n, csv_column(t, "sentence")), found->quick);
    return t ? t->rows : 0;
}

void report_claim_write(FILE *file, const struct report_found *found,
                        struct report_tally *tally)
{
    char text[128];

    for (int n = 0; report_part_list[n].id; n++) {
        const struct report_part *part = &report_part_list[n];
        const struct report_found *f = &found[n];
        if (!part->paper)
            continue;
        if (!f->there || *f->trouble) {
            snprintf(text, sizeof text, "clothbench %.100s", part->command);
            write(file, tally, part, part->title, f->there ? "damaged" : "not run",
                  f->there ? f->trouble : text, false);
        } else if (!write_kept(file, tally, part, f)) {
            write(file, tally, part, part->title, "cannot be judged",
                  "The file has none of the paper's sentences.", f->quick);
        }
    }
}
