#include <ctype.h>
#include <dirent.h>
#include <math.h>
#include <md4c-html.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/output.h"
#include "bench/files/provenance.h"
#include "bench/files/store.h"
#include "bench/report/report_json.h"
#include "bench/report/report_part.h"
#include "bench/report/site_scene.h"
#include "bench/truth/truth.h"
#include "bench/ui/command.h"
#include "bench/ui/html.h"
#include "models/grid.h"
#include "models/reader/named_file.h"
#include "models/reader/scene_file.h"
#include "models/reader/schema.h"

/* --- motions that the page plays, over the ghost of their truth; and stored truths --- */

static const char *const scene = "edge_drop";

enum {
    STEP = 9, /* every so many points of the grid are played                            */
    SIDE = (GRID_U - 1) / STEP + 1, /* points a side                                    */
    NUMBERS = SIDE * SIDE * 3,
    FRAMES_MOST = 400, /* of a truth                                                   */
    FRAME = NUMBERS * 2 * 4 / 3 + 16, /* a frame in the page [bytes]                   */
    ROOM = 1200000,                   /* of all runs there [bytes]                     */
    PATH = 4096
};

/* The state of writing runs into the page. */
struct player {
    FILE *file;
    int members; /* of the array so far                                                */
    int runs;    /* that share the room left                                           */
    long room;   /* [bytes]                                                            */
};

static void write_numbers(FILE *file, const char *key, const double *value, int count)
{
    fprintf(file, "\"%s\":[", key);
    for (int n = 0; n < count; n++) {
        fputs(n ? "," : "", file);
        report_json_number(file, value[n]);
    }
    fputs("],", file);
}

static void begin_motion(struct player *p, const char *name)
{
    fputs(p->members++ ? ",{" : "{", p->file);
    report_json_pair(p->file, "name", name);
}

/* Writes the name of a run that is not played, with the reason. */
static void write_trouble(struct player *p, const char *name, const struct message *why)
{
    begin_motion(p, name);
    fputs("\"trouble\":", p->file);
    report_json_string(p->file, why->text);
    fputc('}', p->file);
}

/* Writes positions [frames][NUMBERS] as 16-bit integers, every `stride`-th frame. */
static enum status write_motion(struct player *p, const char *name, bool truth, int stride,
                                int frames, const double *time, const double *xyz)
{
    const size_t count = (size_t)frames * NUMBERS;
    unsigned char *packed = malloc(2 * count + 1);
    double most = 0;

    if (!packed)
        return STATUS_MEMORY;
    for (size_t n = 0; n < count; n++)
        most = fmax(most, fabs(xyz[n]));
    const double scale = most > 0 ? most / INT16_MAX : 1;
    for (size_t n = 0; n < count; n++) {
        const double x = xyz[n] / scale;
        const uint16_t bits = (uint16_t)(int16_t)(isfinite(x) ? lround(x) : 0);
        packed[2 * n] = bits & 255;
        packed[2 * n + 1] = (unsigned char)(bits >> 8);
    }
    begin_motion(p, name);
    fprintf(p->file, "\"truth\":%s,\"side\":%d,\"stride\":%d,\"scale\":%.9g,",
            truth ? "true" : "false", SIDE, stride, scale);
    write_numbers(p->file, "time", time, frames);
    fputs("\"data\":", p->file);
    report_json_bytes(p->file, packed, 2 * count);
    fputc('}', p->file);
    free(packed);
    return STATUS_OK;
}

static enum status write_truth(struct player *p, const struct truth *made)
{
    const int frames = made->claimed < FRAMES_MOST ? made->claimed : FRAMES_MOST;
    double *xyz = calloc((size_t)frames + 1, NUMBERS * sizeof *xyz);
    enum status st = STATUS_MEMORY;

    if (xyz) {
        for (int n = 0; n < frames; n++)
            grid_middle(made->xyz[n], STEP, xyz + (size_t)n * NUMBERS);
        st = write_motion(p, "truth", true, 1, frames, made->time, xyz);
    }
    free(xyz);
    return st;
}

/* Checks that the file belongs to the scene that is played. */
static enum status check_scene(const struct store_read *store, const char *path,
                               struct message *why)
{
    char *name = NULL;
    enum status st;

    TRY(store_read_text(store, "/", "scene_name", &name, why));
    if (strcmp(name, scene) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is of the scene %.60s, not of %s", path,
                        name, scene));
out:
    free(name);
    return st;
}

/* Reads the fields of a run, as many as its share of the room allows, and their times. */
static enum status read_fields(const struct store_read *store, int stride, int frames,
                               double *time, double **xyz, struct message *why)
{
    double *all = malloc(GRID_POINTS * 3 * sizeof *all);
    enum status st = STATUS_OK;

    *xyz = calloc((size_t)frames + 1, NUMBERS * sizeof **xyz);
    if (!all || !*xyz)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < frames; n++) {
        TRY(store_read_frame(store, n * stride, all, why));
        grid_middle(all, STEP, *xyz + (size_t)n * NUMBERS);
        time[n] = time[n * stride];
    }
out:
    free(all);
    return st;
}

static enum status play_file(struct player *p, const char *path, const char *name,
                             struct message *why)
{
    const long share = p->room / (p->runs > 1 ? p->runs : 1) / FRAME;
    const int most = share > 1 ? (int)share : 1;
    struct store_read *store = NULL;
    double *time = NULL, *xyz = NULL;
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &store, why));
    TRY(check_scene(store, path, why));
    TRY(store_read_array(store, "xyz_time", &time, &rows, &columns, why));
    if (columns != 1 || rows != store_read_frames(store))
        TRY(status_fail(why, STATUS_INPUT, "%s: %d times of %d fields", path, rows,
                        store_read_frames(store)));
    const int stride = (rows + most - 1) / most > 1 ? (rows + most - 1) / most : 1;
    const int frames = (rows + stride - 1) / stride;
    TRY(read_fields(store, stride, frames, time, &xyz, why));
    if (frames)
        TRY(write_motion(p, name, false, stride, frames, time, xyz));
    p->room -= (long)frames * FRAME;
out:
    store_read_close(store);
    free(time);
    free(xyz);
    return st;
}

/* Writes the motion of a result file. A missing one is skipped; for one that cannot be read
 * the reason is written. */
static enum status write_file(struct player *p, const char *path, const char *name)
{
    struct message why = {""};
    const enum status st =
        access(path, F_OK) == 0 ? play_file(p, path, name, &why) : STATUS_OK;

    p->runs--;
    if (st != STATUS_OK && st != STATUS_MEMORY)
        write_trouble(p, name, &why);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

static const char worst[] = "worst_rmse_over_length";

/* Returns the row of row's contestant that is nearest to the truth; -1: none lived. */
static int nearest(const struct csv_table *t, int row)
{
    double least = INFINITY;
    int best = -1;

    for (int n = 0; n < t->rows; n++)
        if (!strcmp(csv_words_of(t, n, "contestant"), csv_words_of(t, row, "contestant")) &&
            csv_number_of(t, n, worst) < least) {
            least = csv_number_of(t, n, worst);
            best = n;
        }
    return best;
}

/* Returns whether a name is made of letters, so that it cannot lead out of the folder. */
static bool is_plain(const char *name)
{
    return *name && strspn(name, "abcdefghijklmnopqrstuvwxyz0123456789_") == strlen(name);
}

/* Writes the run of a row; `frame` is the scene's, and the longest step [s]. */
static enum status write_run(struct player *p, const char *folder,
                             const struct csv_table *t, int row, double frame)
{
    const char *who = csv_words_of(t, row, "contestant");
    const double iterations = csv_number_of(t, row, "iterations"),
                 side = csv_number_of(t, row, "side"),
                 across = csv_number_of(t, row, "across"),
                 steps = frame / csv_number_of(t, row, "step_s");
    char path[PATH], name[128], net[32];

    /* A table written before nets could differ across has no such column; then the sheet is
     * square, and so are the cells that the file's name leaves out. */
    snprintf(net, sizeof net, isnan(across) || across == side ? "%.0f" : "%.0fx%.0f", side,
             across);
    if (!is_plain(who) || !(steps < 1e6) ||
        snprintf(path, sizeof path, "%s/compare_%s/%s_%s_%.0f_%.0f.h5", folder, scene, who,
                 net, steps, iterations > 0 ? iterations : 0) >= (int)sizeof path)
        return STATUS_OK;
    snprintf(name, sizeof name, "%.60s, %.0fx%.0f points, %.3g %% off",
             csv_words_of(t, row, "title"), side, isnan(across) ? side : across,
             100 * csv_number_of(t, row, worst));
    return write_file(p, path, name);
}

static enum status write_runs(struct player *p, const char *folder,
                              const struct csv_table *t)
{
    double frame = 0;
    enum status st = STATUS_OK;

    for (int n = 0; n < t->rows; n++) {
        frame = fmax(frame, csv_number_of(t, n, "step_s"));
        p->runs += nearest(t, n) == n;
    }
    for (int n = 0; n < t->rows; n++)
        if (nearest(t, n) == n)
            TRY(write_run(p, folder, t, n, frame));
out:
    return st;
}

static int is_run(const struct dirent *entry)
{
    const size_t size = strlen(entry->d_name);

    return size > 3 && !strcmp(entry->d_name + size - 3, ".h5");
}

/* Writes all result files of FOLDER/run_SCENE, by name. */
static enum status write_own(struct player *p, const char *folder)
{
    struct dirent **entry = NULL;
    char within[PATH], path[PATH];
    enum status st = STATUS_OK;

    snprintf(within, sizeof within, "%s/run_%s", folder, scene);
    const int count = scandir(within, &entry, is_run, alphasort);
    p->runs += count > 0 ? count : 0;
    for (int n = 0; n < count; n++) {
        if (st == STATUS_OK && snprintf(path, sizeof path, "%s/%s", within,
                                        entry[n]->d_name) < (int)sizeof path)
            st = write_file(p, path, entry[n]->d_name);
        free(entry[n]);
    }
    free(entry);
    return st;
}

/* Reads the stored truth of a scene; *why stays empty where there is none. */
static enum status read_truth(const char *name, struct truth *made, struct message *why)
{
    char *path = NULL, *physics = NULL;
    enum status st;

    TRY(named_file_find(&truth_file_kind, name, &path, NULL));
    TRY(truth_file_read(path, made, &physics, why));
out:
    free(physics);
    free(path);
    return st;
}

/* Writes members of an array of JSON: the stored truth of edge_drop, all its frames; every
 * result file of FOLDER/run_edge_drop; then the nearest run of every contestant of
 * `compare` that left its file in `folder`. {"name", "truth", "side", "stride", "scale",
 * "time", "data"}: int16 [times][side][side][3] of the mid-surface, little endian, in
 * base64, times scale [m]; of a run with more frames than there is room for every
 * stride-th. A file that cannot be read gives {"name", "trouble"}. STATUS_MEMORY. */
static enum status report_motion_write(FILE *file, const char *folder,
                                       const struct report_found *compare)
{
    struct player p = {.file = file, .room = ROOM};
    struct truth made = {0};
    struct message why = {""};
    enum status st = read_truth(scene, &made, &why);

    if (st != STATUS_OK && *why.text)
        write_trouble(&p, "truth", &why); /* runs are played without it, too */
    TRY(st == STATUS_OK ? write_truth(&p, &made) : st == STATUS_MEMORY ? st : STATUS_OK);
    TRY(write_own(&p, folder));
    if (compare->tables)
        TRY(write_runs(&p, folder, compare->table[0]));
out:
    truth_clear(&made);
    return st;
}

static enum status write_stored(FILE *file, const char *name, struct message *why)
{
    struct truth made = {0};
    enum status st;

    TRY(read_truth(name, &made, why));
    const int times = made.times < FRAMES_MOST ? made.times : FRAMES_MOST;
    report_json_pair(file, "note", made.source);
    report_json_pair(file, "horizon", made.horizon);
    report_json_pair(file, "commit", made.commit);
    write_numbers(file, "time", made.time, times);
    write_numbers(file, "bar", made.error, times);
    fprintf(file, "\"claimed\":%d,", made.claimed);
out:
    truth_clear(&made);
    return st;
}

/* Writes members of an array: {"scene", "note", "horizon", "commit", "time", "bar",
 * "claimed"} of each stored truth, or its "trouble". Bars are in metres. STATUS_MEMORY. */
static enum status report_motion_truths(FILE *file)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&truth_file_kind, &entries, &count, NULL));
    for (int n = 0; n < count && st == STATUS_OK; n++) {
        struct message why = {""};
        fputs(n ? ",{" : "{", file);
        if (write_stored(file, entries[n].name, &why) == STATUS_MEMORY)
            st = STATUS_MEMORY;
        report_json_pair(file, "trouble", why.text);
        fputs("\"scene\":", file);
        report_json_string(file, entries[n].name);
        fputc('}', file);
    }
out:
    named_file_list_free(entries, count);
    return st == STATUS_MEMORY ? st : STATUS_OK;
}

/* --- the one page of all results: page.html, which comes with the program, filled in */

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
    TRY(report_part_summary(file, found, said));
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

/* Writes the page about `folder` with all data, and pictures as far as there is room for
 * them; fills `said` with what was found. STATUS_INPUT: there is no page of ours to fill
 * in, or more than fits; STATUS_MEMORY. */
static enum status report_page_write(FILE *file, const char *folder,
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

/* --- the manual --- */

enum { TITLE = 200 };

static char *describe(const char *path);

/* The places of the manual's pages, doc/NAME.md. */
static const struct named_file_kind kind = {
    .what = "page of the manual",
    .ending = ".md",
    .environment = "CLOTHBENCH_MANUAL",
    .from_program = MANUAL_FROM_PROGRAM,
    .in_source = MANUAL_IN_SOURCE,
    .describe = describe,
};

/* A page that is written. */
struct page {
    FILE *file;
    const char *source;                     /* its path                                 */
    const char *folder;                     /* of the site                              */
    const struct named_file_entry *entries; /* all pages                                */
    int count;
    struct message *why;
    enum status status;
};

/* Returns the words of the page's first line, without the marks of a heading. */
static char *describe(const char *path)
{
    struct message why;
    char *text = NULL;
    size_t size;
    const enum status st = named_file_read(&kind, path, &text, &size, &why);

    if (st != STATUS_OK)
        return st == STATUS_MEMORY ? NULL : strdup(path);
    text[strcspn(text, "\n")] = '\0';
    memmove(text, text + strspn(text, "# "), strlen(text + strspn(text, "# ")) + 1);
    return text;
}

/* Blanks comments, which say from which table a part of a page is filled in. */
static void blank_comments(char *text)
{
    for (char *begin = text; (begin = strstr(begin, "<!--"));) {
        char *end = strstr(begin, "-->");
        if (!end)
            return;
        memset(begin, ' ', (size_t)(end + 3 - begin));
    }
}

static void collect(const MD_CHAR *text, MD_SIZE size, void *stream)
{
    fwrite(text, 1, size, stream);
}

/* Writes the anchor of a heading as forges make it from the words up to `end`: letters in
 * lower case, digits, '-' for blanks. */
static void write_anchor(FILE *file, const char *words, const char *end)
{
    bool tag = false;

    fputs(" id=\"", file);
    for (; words < end; words++) {
        tag = *words == '<' || (tag && *words != '>');
        if (tag || *words == '>')
            continue;
        if (isalnum((unsigned char)*words) || *words == '_' || *words == '-')
            fputc(tolower((unsigned char)*words), file);
        else if (*words == ' ')
            fputc('-', file);
    }
    fputc('"', file);
}

/* Copies a picture that lies beside the page. */
static enum status copy_picture(struct page *p, const char *name)
{
    struct output *out = NULL;
    char from[PATH], to[PATH], *bytes = NULL;
    size_t size = 0;
    enum status st;
    const char *slash = strrchr(p->source, '/');

    if (snprintf(from, sizeof from, "%.*s%s", (int)(slash + 1 - p->source), p->source,
                 name) >= (int)sizeof from ||
        snprintf(to, sizeof to, "%s/%s", p->folder, name) >= (int)sizeof to)
        return status_fail(p->why, STATUS_INPUT, "%.60s: its path is too long", name);
    TRY(named_file_read(&kind, from, &bytes, &size, p->why));
    TRY(output_create(to, &out, p->why));
    fwrite(bytes, 1, size, output_stream(out));
    TRY(output_close(&out, p->why));
out:
    output_discard(out);
    free(bytes);
    return st;
}

/* Writes where a link leads in the site, "compare.md#seconds"; nothing where a file is no
 * page. */
static void write_target(const struct page *p, const char *link)
{
    const size_t size = strcspn(link, "#");

    if (*link == '#' || !strncmp(link, "https://", 8) || !strncmp(link, "http://", 7)) {
        fprintf(p->file, " href=\"%s\"", link);
        return;
    }
    for (int n = 0; n < p->count; n++)
        if (size == strlen(p->entries[n].name) + 3 && !strncmp(link + size - 3, ".md", 3) &&
            !strncmp(link, p->entries[n].name, size - 3))
            fprintf(p->file, " href=\"manual_%s.html%s\"", p->entries[n].name, link + size);
}

/* Writes an attribute's value, which the renderer has escaped, as the site has it. */
static void write_link(struct page *p, bool picture, const char *value, size_t size)
{
    char link[TITLE] = "";

    if (size < sizeof link)
        snprintf(link, sizeof link, "%.*s", (int)size, value);
    if (!picture) {
        write_target(p, link);
        return;
    }
    if (strcmp(link + strspn(link, "abcdefghijklmnopqrstuvwxyz_"), ".svg") != 0) {
        p->status = status_fail(p->why, STATUS_INPUT,
                                "%s: the picture '%s' is no NAME.svg beside the page",
                                p->source, link);
        return;
    }
    fprintf(p->file, " src=\"%s\"", link);
    p->status = copy_picture(p, link);
}

/* Writes the page's HTML as the renderer made it, which has tags of its own alone, with
 * anchors at headings, links between pages of the site, and tables that scroll. */
static void write_html(struct page *p, const char *html)
{
    while (*html && p->status == STATUS_OK) {
        const bool picture = !strncmp(html, "<img src=\"", 10);
        if (picture || !strncmp(html, "<a href=\"", 9)) {
            const char *value = strchr(html, '"') + 1;
            fputs(picture ? "<img" : "<a", p->file);
            write_link(p, picture, value, strcspn(value, "\""));
            html = value + strcspn(value, "\"") + 1;
        } else if (!strncmp(html, "<h", 2) && isdigit((unsigned char)html[2])) {
            fprintf(p->file, "<h%c", html[2]);
            write_anchor(p->file, html + 4, strstr(html, "</h"));
            html += 3;
        } else if (!strncmp(html, "<table>", 7)) {
            fputs("<div class=\"scroll\" tabindex=\"0\"><table class=\"manual\">", p->file);
            html += 7;
        } else if (!strncmp(html, "</table>", 8)) {
            fputs("</table></div>", p->file);
            html += 8;
        } else
            fputc(*html++, p->file);
    }
}

/* Writes the text below the page's first line, its title, which stands above it already. */
static enum status write_text(struct page *p, char *text)
{
    char *html = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&html, &size);
    const char *rest = strchr(text, '\n');

    if (!stream)
        return STATUS_MEMORY;
    blank_comments(text);
    const int failed = rest && md_html(rest, (MD_SIZE)strlen(rest), collect, stream,
                                       MD_FLAG_TABLES | MD_FLAG_NOHTML, 0);
    if (fclose(stream) != 0 || failed) {
        free(html);
        return STATUS_MEMORY;
    }
    write_html(p, html);
    free(html);
    return p->status;
}

static enum status write_page(struct page *p, const struct named_file_entry *entry)
{
    struct output *out = NULL;
    char *path = NULL, *text = NULL;
    size_t size;
    enum status st;

    TRY(named_file_find(&kind, entry->name, &path, p->why));
    TRY(named_file_read(&kind, path, &text, &size, p->why));
    TRY(html_open(p->folder, "manual", entry->name, entry->text, &out, p->why));
    p->file = output_stream(out);
    p->source = path;
    TRY(write_text(p, text));
    TRY(html_close(&out, p->why));
out:
    output_discard(out);
    free(text);
    free(path);
    return st;
}

/* Writes manual_NAME.html for each page of the manual, the pictures that they show beside
 * them, and an item of a list with a link to each into `list`. Links between pages stay
 * links; those to files that are no page become plain text. */
static enum status site_manual_write(const char *folder, FILE *list, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_list(&kind, &entries, &count, why));
    for (int n = 0; n < count; n++) {
        struct page p = {.folder = folder, .entries = entries, .count = count, .why = why};
        TRY(write_page(&p, &entries[n]));
        html_print(list, "<li><a href=\"manual_%s.html\">%s</a></li>\n", entries[n].name,
                   entries[n].text);
    }
out:
    named_file_list_free(entries, count);
    return st;
}

/* --- a contestant's page --- */

enum { WORDS = 16 }; /* of an option, at most */

static void write_rungs(FILE *file, const char *what, const int value[CONTESTANT_STEPS])
{
    if (!value[0])
        return;
    html_print(file, "<li>%s", what);
    for (int n = 0; n < CONTESTANT_STEPS && value[n]; n++)
        fprintf(file, "%s %d", n ? "," : ":", value[n]);
    fputs("</li>\n", file);
}

static void write_option(void *file, const char *key, const char *text)
{
    html_print(file,
               "<tr><td class=\"word\"><code>%s</code></td><td class=\"word\">%s</td>"
               "</tr>\n",
               key, text);
}

/* Writes a model's options; those that it shares with others are described by their table,
 * with the words that it has of them. */
static void write_options(FILE *file, const struct schema_key *options)
{
    for (; options->key; options++) {
        const struct schema_key *shared = option_find(option_shared, options->key);
        struct schema_key one[2] = {options->what ? *options : *shared, {0}};
        const char *some[WORDS] = {NULL};
        for (int n = 0, count = 0; options->only && one[0].words[n]; n++)
            if (options->only & OPTION(n) && count < WORDS - 1)
                some[count++] = one[0].words[n];
        if (options->only)
            one[0].words = some;
        schema_list(one, "discretization.", write_option, file);
    }
}

static void write_settings(FILE *file, const struct contestant *c)
{
    html_print(
        file,
        "<h2 id=\"settings\">Settings</h2>\n<p><code>clothbench run edge_drop "
        "--model %s</code> runs it. It is the model <code>%s</code> with</p>\n<ul>\n",
        c->name, c->model->name);
    for (int n = 0; n < CONTESTANT_SETTINGS && c->settings[n]; n++)
        html_print(file, "<li><code>%s</code></li>\n", c->settings[n]);
    if (!c->settings[0])
        fputs("<li>the model's own defaults</li>\n", file);
    write_rungs(file, "points a side, from cheap to expensive", c->points);
    write_rungs(file, "steps that a frame of the scene is divided into", c->divisors);
    write_rungs(file, "iterations a step", c->iterations);
    fputs("</ul>\n<h2 id=\"options\">Options of the model</h2>\n", file);
    html_table(file, "<--set|<value");
    write_options(file, c->model->options);
    html_table_end(file);
}

/* Writes the name of a scene, as a link where the scene is one of the program's. */
static void write_scene(FILE *file, const char *name)
{
    struct message why;
    char *path = NULL;

    if (!strchr(name, '/') && scene_file_find(name, &path, &why) == STATUS_OK)
        html_print(file, "<td class=\"word\"><a href=\"scene_%s.html\">%s</a></td>", name,
                   name);
    else
        html_print(file, "<td class=\"word\">%s</td>", name);
    free(path);
}

/* Ends a table of so many rows, or says what would measure them. */
static void end_table(FILE *file, int rows, const char *command, const char *name)
{
    if (rows)
        html_table_end(file);
    else
        html_print(file,
                   "<p>Not measured: <code>clothbench %s ... --models %s</code></p>\n",
                   command, name);
}

static void write_scenes(FILE *file, const struct csv_table *t, const char *name)
{
    int all = 0;

    fputs("<h2 id=\"scenes\">On the scenes</h2>\n", file);
    for (int row = 0; t && row < t->rows; row++) {
        if (strcmp(csv_words_of(t, row, "contestant"), name) != 0)
            continue;
        if (!all++)
            html_table(file,
                       "<scene|error asked [%]|seconds to it|lowest error [%]|points");
        fputs("<tr>", file);
        write_scene(file, csv_words_of(t, row, "scene"));
        html_print(file, "<td>%g</td><td>%g</td><td>%g</td><td>",
                   100 * csv_number_of(t, row, "target_rmse_over_length"),
                   csv_number_of(t, row, "seconds"),
                   100 * csv_number_of(t, row, "lowest_rmse_over_length"));
        if (csv_number_of(t, row, "refused") == 1)
            fputs("refused</td></tr>\n", file);
        else
            html_print(file, "%gx%g</td></tr>\n", csv_number_of(t, row, "side"),
                       csv_number_of(t, row, "across"));
    }
    end_table(file, all, "compare", name);
}

static void write_cases(FILE *file, const struct csv_table *t, const char *name)
{
    int all = 0;

    fputs("<h2 id=\"cases\">Hard cases</h2>\n", file);
    for (int row = 0; t && row < t->rows; row++) {
        if (strcmp(csv_words_of(t, row, "model"), name) != 0)
            continue;
        if (!all++)
            html_table(file, "<case|<end|error|<in words");
        html_print(file,
                   "<tr><td class=\"word\">%s</td><td class=\"word\">%s</td><td>%g</td>"
                   "<td class=\"word\">%s</td></tr>\n",
                   csv_words_of(t, row, "case"), csv_words_of(t, row, "end"),
                   csv_number_of(t, row, "error"), csv_words_of(t, row, "in_words"));
    }
    end_table(file, all, "stress", name);
}

/* Returns the table of a part that has a key; NULL: there is none. */
static const struct csv_table *table_with(const struct report_found *f, const char *key)
{
    for (int n = 0; n < f->tables; n++)
        if (csv_column(f->table[n], key) >= 0)
            return f->table[n];
    return NULL;
}

/* Writes the page contestant_NAME.html - its rows over scenes and hard cases, its settings
 * and options -, and a row of the index's table of contestants into `rows`. */
static enum status site_contestant_write(const char *out, const struct report_found *found,
                                         const struct contestant *c, FILE *rows,
                                         struct message *why)
{
    char model[CONTESTANT_TEXT], note[CONTESTANT_TEXT];
    struct output *page = NULL;
    enum status st;

    contestant_tell_model(c->model, model);
    contestant_tell(c, note);
    TRY(html_open(out, "contestant", c->name, c->title, &page, why));
    FILE *file = output_stream(page);
    html_print(file, "<p><code>%s</code>: %s.</p>\n<p class=\"soft\">The model: %s.</p>\n",
               c->name, note, model);
    write_scenes(file,
                 table_with(report_part_found(found, "scenes"), "target_rmse_over_length"),
                 c->name);
    write_cases(file, table_with(report_part_found(found, "stress"), "end"), c->name);
    write_settings(file, c);
    TRY(html_close(&page, why));
    html_print(rows,
               "<tr><td class=\"word\"><a href=\"contestant_%s.html\">%s</a></td>"
               "<td class=\"word\">%s</td><td class=\"word\">%s</td></tr>\n",
               c->name, c->name, c->title, c->model->title);
out:
    output_discard(page);
    return st;
}

/* --- the site --- */

/* A static site of all that is known: an index, a page for each scene and
 * each contestant, the manual, and the page of all results. It needs no server, and but for
 * the last page no script; everything is in one folder, and links are relative. */

/* The file that says that a folder is a site, and what other files a site has. */
#define MARK    "clothbench.site"
#define ENDINGS "|.html|.css|.svg|"

/* The lists of the index: rows of tables, and items; written by the pages that they name.
 */
enum list { SCENES, CONTESTANTS, PAGES, LISTS };

struct site {
    const char *out, *folder; /* of the site, and of the results                        */
    const struct report_found *found;
    FILE *list[LISTS];
    char *text[LISTS]; /* owned                                                          */
    size_t size[LISTS];
    char said[REPORT_SENTENCES][REPORT_SENTENCE];
};

static enum status open_lists(struct site *s)
{
    for (int n = 0; n < LISTS; n++) {
        s->list[n] = open_memstream(&s->text[n], &s->size[n]);
        if (!s->list[n])
            return STATUS_MEMORY;
    }
    return STATUS_OK;
}

/* Ends the lists, whose text is then complete. */
static enum status close_lists(struct site *s)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < LISTS; n++) {
        if (s->list[n] && fclose(s->list[n]) != 0)
            st = STATUS_MEMORY;
        s->list[n] = NULL;
    }
    return st;
}

static enum status write_scene_pages(struct site *s, struct message *why)
{
    struct named_file_entry *entries = NULL;
    int count = 0;
    enum status st;

    TRY(named_file_names(&scene_file_kind, &entries, &count, why));
    for (int n = 0; n < count; n++)
        TRY(site_scene_write(s->out, s->folder, s->found, entries[n].name, s->list[SCENES],
                             why));
out:
    named_file_list_free(entries, count);
    return st;
}

static enum status write_contestants(struct site *s, struct message *why)
{
    enum status st = STATUS_OK;

    for (const struct contestant *c = contestant_table; c->name; c++)
        TRY(site_contestant_write(s->out, s->found, c, s->list[CONTESTANTS], why));
out:
    return st;
}

/* Writes the page of all results, the style and the mark. */
static enum status write_files(struct site *s, struct message *why)
{
    static const char *const name[] = {"report.html", "style.css", MARK};
    struct output *out = NULL;
    char path[PATH];
    enum status st;

    for (int n = 0; n < 3; n++) {
        if (snprintf(path, sizeof path, "%s/%s", s->out, name[n]) >= (int)sizeof path)
            TRY(status_fail(why, STATUS_INPUT, "%.60s...: the path is too long", s->out));
        TRY(output_create(path, &out, why));
        FILE *file = output_stream(out);
        if (n == 0)
            TRY(report_page_write(file, s->folder, s->found, s->said, why));
        else if (n == 1)
            TRY(html_style(file, why));
        else
            fputs("clothbench report --site writes this folder, and replaces it.\n", file);
        TRY(output_close(&out, why));
    }
out:
    output_discard(out);
    return st;
}

static void write_sentences(struct site *s, FILE *file)
{
    static struct provenance made;
    char commit[13];

    provenance_collect(&made);
    snprintf(commit, sizeof commit, "%s", provenance_value(&made, "commit"));
    html_print(
        file, "<p>Which cloth model, at which resolution, gives the motion of a scene to a "
              "required error at the least cost? Models of the same sheet run through the "
              "same scenes, and are compared with truths that have error bars.</p>\n");
    for (int n = 0; n < REPORT_SENTENCES; n++)
        html_print(file, "<p>%s</p>\n", s->said[n]);
    html_print(file, "<p class=\"soft\">%s, commit %s, %s, from the results in %s.</p>\n",
               provenance_value(&made, "program"), commit, provenance_value(&made, "date"),
               s->folder);
}

static enum status write_index(struct site *s, struct message *why)
{
    struct output *out = NULL;
    enum status st;

    TRY(html_open(s->out, NULL, "index", "Cloth models, their speed and their error", &out,
                  why));
    FILE *file = output_stream(out);
    write_sentences(s, file);
    if (report_part_runs(report_part_found(s->found, "compare")))
        html_print(file, "<h2 id=\"speed\">Speed against error on "
                         "<a href=\"scene_edge_drop.html\">edge_drop</a></h2>\n");
    TRY(site_scene_chart(file, s->folder, s->found, "edge_drop"));
    fputs("<h2 id=\"scenes\">Scenes</h2>\n<p>Up to when a scene's motion is known, and how "
          "well it is then, in per cent of the sheet's length.</p>\n",
          file);
    html_table(file, "<scene|known to [s]|error bar [%]|<what happens");
    fputs(s->text[SCENES], file);
    html_table_end(file);
    fputs("<h2 id=\"contestants\">Contestants</h2>\n<p>A contestant is a model with "
          "settings.</p>\n",
          file);
    html_table(file, "<name|<title|<model");
    fputs(s->text[CONTESTANTS], file);
    html_table_end(file);
    html_print(file, "<h2 id=\"manual\">The manual</h2>\n<ul>\n");
    fputs(s->text[PAGES], file);
    fputs("</ul>\n", file);
    TRY(html_close(&out, why));
out:
    output_discard(out);
    return st;
}

/* Writes the site about the results in `folder` into the folder `path`, which appears as a
 * whole. STATUS_INPUT with a sentence: there is a folder of that name which is no site, or
 * a scene or page of the manual is wrong; STATUS_FILE, STATUS_MEMORY. */
static enum status site_index_write(const char *path, const char *folder,
                                    const struct report_found *found, struct message *why)
{
    struct folder_aside aside = {0};
    struct site *s = calloc(1, sizeof *s);
    enum status st = STATUS_MEMORY;

    if (!s)
        return st;
    TRY(folder_aside_replace(path, MARK, ENDINGS, &aside, why));
    *s = (struct site){.out = aside.temporary, .folder = folder, .found = found};
    TRY(open_lists(s));
    TRY(write_files(s, why));
    TRY(write_scene_pages(s, why));
    TRY(write_contestants(s, why));
    TRY(site_manual_write(s->out, s->list[PAGES], why));
    TRY(close_lists(s));
    TRY(write_index(s, why));
    TRY(folder_aside_commit(&aside, why));
    printf("%s: a site; begin with its index.html\n", path);
out:
    folder_aside_discard(&aside);
    close_lists(s);
    for (int n = 0; n < LISTS; n++)
        free(s->text[n]);
    free(s);
    return st;
}

/* --- the command --- */

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
