#include "bench/report/report.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/report/report_json.h"
#include "bench/report/report_motion.h"
#include "bench/report/report_summary.h"
#include "models/reader/named_file.h"

/* The page is smaller than this [bytes]. */
#define MOST 10000000

static const struct named_file_kind page_kind = {
    .what = "page",
    .ending = ".html",
    .environment = "CLOTHBENCH_REPORT",
    .from_program = REPORT_FROM_PROGRAM,
    .in_source = REPORT_IN_SOURCE,
};

/* The place in the page that the data replace. */
static const char mark[] = "@DATA@";

static void write_provenance(FILE *file)
{
    static struct provenance p;

    provenance_collect(&p);
    fputs("\"made\":{", file);
    for (int n = 0; n < p.count; n++)
        report_json_pair(file, p.entry[n].key, p.entry[n].value);
    fputs("\"by\":\"clothbench report\"},", file);
}

/* Writes all data but the pictures, without the last brace. */
static enum status write_data(FILE *file, const char *folder,
                              const struct report_found *found)
{
    enum status st;

    fputc('{', file);
    report_json_pair(file, "folder", folder);
    write_provenance(file);
    TRY(report_summary_write(file, found));
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

static enum status read_page(char **page, char **rest, struct message *why)
{
    char *path = NULL;
    size_t size;
    enum status st;

    TRY(named_file_find(&page_kind, "page", &path, why));
    TRY(named_file_read(&page_kind, path, page, &size, why));
    char *text = realloc(*page, size + 1);
    if (!text)
        TRY(STATUS_MEMORY);
    *page = text;
    text[size] = '\0';
    *rest = strstr(text, mark);
    if (!*rest)
        TRY(status_fail(why, STATUS_INPUT, "%s: the page has no %s", path, mark));
    **rest = '\0';
    *rest += strlen(mark);
out:
    free(path);
    return st;
}

/* Writes the page with all data, and pictures as far as there is room for them. */
static enum status write_page(FILE *file, const char *folder,
                              const struct report_found *found, struct message *why)
{
    char *page = NULL, *rest;
    enum status st;

    TRY(read_page(&page, &rest, why));
    fputs(page, file);
    TRY(write_data(file, folder, found));
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

/* Makes the page about `folder` at `path`. STATUS_INPUT: there is no such folder, no page
 * of ours to fill in, or more than fits. */
static enum status make_page(const char *folder, const char *path, struct message *why)
{
    struct report_found *found = calloc(REPORT_PARTS_MOST, sizeof *found);
    struct output *out = NULL, *done;
    struct stat what;
    enum status st = STATUS_OK;

    if (!found)
        TRY(STATUS_MEMORY);
    if (stat(folder, &what) != 0 || !S_ISDIR(what.st_mode))
        TRY(status_fail(why, STATUS_INPUT,
                        "%s: there is no such folder of results; clothbench table 1 makes "
                        "the first of them in results/",
                        folder));
    for (int n = 0; report_part_list[n].id; n++)
        TRY(report_part_find(folder, &report_part_list[n], &found[n]));
    TRY(output_create(path, &out, why));
    TRY(write_page(output_stream(out), folder, found, why));
    const long size = ftell(output_stream(out));
    done = out, out = NULL;
    TRY(output_close(done, why));
    printf("%s: one page, %ld kB\n", path, size / 1000);
out:
    output_discard(out);
    for (int n = 0; found && report_part_list[n].id; n++)
        report_part_clear(&found[n]);
    free(found);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *folder = line->word_count ? line->words[0] : "results";
    const char *out = command_value(line, "--out");
    char path[4096];

    if (snprintf(path, sizeof path, "%s/report.html", folder) >= (int)sizeof path)
        return status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", folder);
    return make_page(folder, out ? out : path, why);
}

static const struct command_option options[] = {
    {"--out", "FILE", false, "the page (DIR/report.html)"},
    {NULL, NULL, false, NULL},
};

const struct command report_command = {
    .name = "report",
    .summary = "write one page of HTML from all results: what holds, what does not, what "
               "is missing",
    .arguments = "[DIR] [OPTION]...",
    .text =
        "Writes one self-contained page from the results that the other commands left in\n"
        "DIR (results): the verdict on every claim of the paper, tables, pictures beside\n"
        "the paper's captions, speed against error, verification, hard cases, truths\n"
        "with their error bars, and motions to play. The page needs no network and no\n"
        "server, and stays under 10 MB. It names the command that makes what is missing,\n"
        "and says what is wrong with a damaged file.\n",
    .examples = "report\nreport results --out page.html\n",
    .most = 1,
    .options = options,
    .run = run,
};
