#include <stdio.h>
#include <sys/stat.h>

#include "bench/ui/command.h"
#include "bench/ui/show.h"

static enum status run(struct command_line *line, struct message *why)
{
    const char *folder = line->word_count ? line->words[0] : "results";
    const char *out = command_value(line, "--out"), *site = command_value(line, "--site");
    struct stat what;
    char path[4096];

    if (out && site)
        return status_fail(why, STATUS_INPUT,
                           "report takes --out or --site, one of the two");
    if (stat(folder, &what) != 0 || !S_ISDIR(what.st_mode))
        return status_fail(
            why, STATUS_INPUT,
            "%s: there is no such folder of results; clothbench table 1 makes "
            "the first of them in results/",
            folder);
    if (snprintf(path, sizeof path, "%s/report.html", folder) >= (int)sizeof path)
        return status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", folder);
    return show_run((const char *const[]){site ? "site" : "page", folder,
                                          site  ? site
                                          : out ? out
                                                : path,
                                          NULL},
                    why);
}

static const struct command_option options[] = {
    {"--out", "FILE", false, "the page (DIR/report.html)"},
    {"--site", "FOLDER", false,
     "a site in place of the page: a new folder, or a site, which it replaces"},
    {NULL, NULL, false, NULL},
};

const struct command report_command = {
    .name = "report",
    .summary = "show all results on one page: pictures, speed against error, what holds",
    .arguments = "[DIR] [OPTION]...",
    .text =
        "Makes one page of what the other commands left in DIR (results): the paper's\n"
        "figures recomputed, speed against error, the paper's statements, and then the\n"
        "charts, pictures and tables of everything else in it, plans, sweeps, scores and\n"
        "runs of yours included. The page needs no network and no server, and has at\n"
        "most 5 MB. What is damaged is named, and the rest is shown.\n"
        "With --site it makes a folder of pages instead: this page, one for each scene\n"
        "with its truth, and the manual; begin with its index.html.\n"
        "Pages are made by Debian's Python (python3-numpy, python3-h5py,\n"
        "python3-matplotlib, python3-jinja2; python3-markdown for the manual).\n",
    .examples = "report\nreport results --out page.html\nreport --site site\n",
    .most = 1,
    .options = options,
    .run = run,
};
