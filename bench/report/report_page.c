#include "bench/report/report_page.h"

#include <stdlib.h>
#include <string.h>

#include "bench/files/provenance.h"
#include "bench/report/report_json.h"
#include "bench/report/report_motion.h"
#include "bench/report/site_parts.h"
#include "bench/ui/html.h"

/* The page is smaller than this [bytes]. */
#define MOST 10000000

static void write_provenance(FILE *file)
{
    static struct provenance p;

    provenance_collect(&p);
    fputs("\"made\":{", file);
    for (int n = 0; n < p.count; n++)
        report_json_pair(file, p.entry[n].key, p.entry[n].value);
    fputs("\"by\":\"clothbench report\"},", file);
}

static enum status write_chart(FILE *file, const char *folder,
                               const struct report_found *found)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);

    if (!stream)
        return STATUS_MEMORY;
    enum status st = site_scene_chart(stream, folder, found, "edge_drop");
    if (fclose(stream) != 0)
        st = STATUS_MEMORY;
    if (st == STATUS_OK)
        report_json_pair(file, "chart", text);
    free(text);
    return st;
}

/* Writes all data but the pictures, without the last brace. */
static enum status write_data(FILE *file, const char *folder,
                              const struct report_found *found,
                              char said[REPORT_SENTENCES][REPORT_SENTENCE])
{
    enum status st;

    fputc('{', file);
    report_json_pair(file, "folder", folder);
    write_provenance(file);
    TRY(report_summary_write(file, found, said));
    TRY(write_chart(file, folder, found));
    fputs("\"parts\":[", file);
    for (int n = 0; report_part_list[n].id; n++) {
        fputs(n ? "," : "", file);
        report_part_write(file, &report_part_list[n], &found[n]);
    }
    fputs("],\"truths\":[", file);
    TRY(report_motion_truths(file));
    fputs("],\"motions\":[", file);
    TRY(report_motion_write(file, folder, report_part_found(found, "compare")));
    fputs("],\"pictures\":[", file);
out:
    return st;
}

enum status report_page_write(FILE *file, const char *folder,
                              const struct report_found *found,
                              char said[REPORT_SENTENCES][REPORT_SENTENCE],
                              struct message *why)
{
    char *page = NULL, *rest;
    enum status st;

    TRY(html_page_read(&page, &rest, why));
    fputs(page, file);
    TRY(write_data(file, folder, found, said));
    const long room = MOST - ftell(file) - (long)strlen(rest) - 64 * 1024;
    if (room < 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: its tables alone make a page of more than %d bytes", folder,
                        MOST));
    TRY(report_part_pictures(file, folder, room));
    fputs("]}", file);
    fputs(rest, file);
out:
    free(page);
    return st;
}
