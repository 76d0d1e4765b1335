#include "bench/ui/command.h"

#include <stdlib.h>
#include <sys/stat.h>

#include "bench/files/output.h"
#include "bench/report/report_page.h"
#include "bench/report/site_index.h"

static enum status make_page(const char *folder, const struct report_found *found,
                             const char *path, struct message *why)
{
    char said[REPORT_SENTENCES][REPORT_SENTENCE];
    struct output *out = NULL;
    enum status st;

    TRY(output_create(path, &out, why));
    TRY(report_page_write(output_stream(out), folder, found, said, why));
    const long size = ftell(output_stream(out));
    TRY(output_close(&out, why));
    printf("%s: one page, %ld kB\n", path, size / 1000);
out:
    output_discard(out);
    return st;
}

/* Reads the results in `folder`, and makes the site or the page. STATUS_INPUT: there is no
 * such folder. */
static enum status make(const char *folder, const char *page, const char *site,
                        struct message *why)
{
    struct report_found *found = calloc(REPORT_PARTS_MOST, sizeof *found);
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
    if (site)
        TRY(site_index_write(site, folder, found, why));
    else
        TRY(make_page(folder, found, page, why));
out:
    for (int n = 0; found && report_part_list[n].id; n++)
        report_part_clear(&found[n]);
    free(found);
    return st;
}

static enum status run(const struct command_line *line, struct message *why)
{
    const char *folder = line->word_count ? line->words[0] : "results";
    const char *out = command_value(line, "--out"), *site = command_value(line, "--site");
    char path[4096];

    if (out && site)
        return status_fail(why, STATUS_INPUT, "--out or --site, one of the two");
    if (snprintf(path, sizeof path, "%s/report.html", folder) >= (int)sizeof path)
        return status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", folder);
    return make(folder, out ? out : path, site, why);
}

static const struct command_option options[] = {
    {"--out", "FILE", false, "the page (DIR/report.html)"},
    {"--site", "FOLDER", false,
     "a site in place of the page: a new folder, or a site, which it replaces"},
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
        "and says what is wrong with a damaged file.\n"
        "With --site it writes a folder of pages instead, with an index, a page for each\n"
        "scene and each contestant, and the manual; begin with its index.html.\n",
    .examples = "report\nreport results --out page.html\nreport --site site\n",
    .most = 1,
    .options = options,
    .run = run,
};
