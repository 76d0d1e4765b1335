#include "bench/report/report_part.h"

#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/experiment/judge.h"
#include "bench/experiment/kept.h"
#include "bench/report/report_json.h"
#include "models/reader/input_file.h"

enum { PATH = 4096, TABLE_MOST = 300000 /* bytes of a table's words */ };
enum { PICTURE_MOST = 4 << 20 };

#define FIG12                                                                              \
    "Fig. 12, nets of 5, 10, 15 and 20 points at 1.025 s: the denser the control "         \
    "net, the more wrinkles"
#define FIG13 "Fig. 13, p = q = 2, 3, 4 at 1.7 s: more bending detail, smoother"
#define FIG14                                                                              \
    "Fig. 14, net and degree together: both add wrinkle detail, elevation makes "          \
    "the cloth smoother"

const struct report_part report_part_list[] = {
    /* clang-format off */
    {"table1", "Table 1: cost at comparable looks", "table 1", .paper = true},
    {"table2", "Table 2: milliseconds a frame", "table 2", .paper = true,
     .picture = {{"cost.png"}}},
    {"table3", "Table 3: cost of degree and net", "table 3", .paper = true,
     .picture = {{"cost.png"}}},
    {"table4", "Table 4: which E, rho and mu give cloth", "table 4", .paper = true},
    {"study_drops", "Falling sheets (Figs. 7 and 8)", "study drops", .paper = true,
     .picture = {{"edge_sheets.png", "Fig. 7, top edge fixed, at 0.5, 1.5, 2.0, 3.25, 3.5 and "
                  "4.25 s: the sheet starts at rest, falls, swings through, and back"},
                 {"corners_sheets.png", "Fig. 8, two top corners fixed, at the same times"}}},
    {"study_mesh", "Denser nets (Fig. 12)", "study mesh", .paper = true,
     .picture = {{"corners_sheets.png", FIG12}, {"edge_sheets.png", FIG12}}},
    {"study_degree", "Higher degrees (Fig. 13)", "study degree", .paper = true,
     .picture = {{"corners_sheets.png", FIG13}, {"edge_sheets.png", FIG13}}},
    {"study_mesh-degree", "Net and degree together (Fig. 14)", "study mesh-degree",
     .paper = true, .picture = {{"corners_sheets.png", FIG14}, {"edge_sheets.png", FIG14}}},
    {"study_thickness", "A thicker cloak (Fig. 10)", "study thickness", .paper = true,
     .picture = {{"printed_sheets.png", "Fig. 10, leather cloak, 1 mm and 5 mm: the thinner "
                  "one swings more"}, {"thickness.png"}}},
    {"study_thickness-degree", "Degree through the thickness (Fig. 11)",
     "study thickness-degree", .paper = true,
     .picture = {{"cloak_sheets.png", "Fig. 11, degree 1, 2 and 3 through the thickness: "
                  "little difference to the linear basis"}}},
    {"study_touching", "Contact: five scenes", "study touching",
     .picture = {{"fold_sheets.png"}, {"stack_sheets.png"}, {"twist_sheets.png"},
                 {"wipe_sheets.png"}, {"drape_sheets.png"}}},
    {"study_control-net", "Contact: is the control net enough?", "study control-net",
     .paper = true},
    {"bench_contact", "Contact: what looking for it costs", "bench contact",
     .file = {"bench_contact.csv", "bench/contact.csv"}},
    {"study_fabrics", "Fabrics, and what their isotropic mean does instead", "study fabrics",
     .show = "fabrics",
     .picture = {{"napkin_cotton_sheets.png"}, {"flag_silk_sheets.png"},
                 {"strip_bias_sheets.png"}}},
    {"study_iterations", "How many iterations?", "study iterations",
     .picture = {{"iterations.png"}}},
    {"study_contact", "Onto the ground (Fig. 9)", "study contact",
     .paper = true,
     .picture = {{"contact_sheets.png", "Fig. 9, cloth onto the ground: collision and "
                  "self-contact are detected on the control net"}}},
    {"study_flag", "A falling flag (Fig. 15)", "study flag",
     .picture = {{"flag_sheets.png", "Fig. 15, flag falling, at 0.75, 1.0 and 2.075 s"}}},
    {"study_artefacts", "Artefacts (Fig. 16)", "study artefacts",
     .paper = true,
     .picture = {{"flag_sheets.png", "Fig. 16: normal, super-elongation, floating, "
                  "penetration"}}},
    {"study_fig6", "Three models side by side (Fig. 6)", "study fig6", .paper = true,
     .picture = {{"fig6_sheets.png", "Fig. 6: mass-spring, projective dynamics and IGA"}}},
    {"study_locking", "Locking", "study locking", .picture = {{"locking.png"}}},
    {"study_cures", "Cures of locking", "study cures", .picture = {{"cures.png"}}},
    {"study_timestep", "Ever shorter steps", "study timestep", .paper = true,
     .picture = {{"timestep.png"}}},
    {"study_direct", "A direct solver suffices", "study direct", .paper = true},
    {"study_plasticity", "What stays when the force is gone", "study plasticity",
     .paper = true},
    {"study_ensemble", "The drape test from eight starts", "study ensemble"},
    {"compare", "Speed against error: edge_drop", "compare edge_drop", .show = "speed",
     .file = {"compare_edge_drop/compare.csv", "compare.csv"},
     .keys = "|title|model|side|across|step_s|iterations|seconds|worst_rmse_over_length|front|"
             "outcome|"},
    {"scenes", "Who wins where", "compare edge_drop corners_patch flag sphere strip_swing "
     "thick stiff", .show = "scenes", .file = {"compare_scenes.csv"}, .folder = ".",
     .keys = "|scene|contestant|seconds|target_rmse_over_length|lowest_rmse_over_length|"
             "refused|", .picture = {{"compare_scenes.png"}}},
    {"verify", "Verification", "verify", .show = "verify", .file = {"verify/", "verify.csv"},
     .keys = "|check|quantity|model|value|truth|error|tolerance|verdict|"},
    {"stress", "Hard cases", "stress", .show = "ends",
     .keys = "|case|model|end|error|until_s|in_words|"},
    {"stability", "Which step serves which stiffness", "sweep stability",
     .folder = "sweep_stability", .file = {"sweep_stability/table.csv", "stability.csv"},
     .keys = "|name|young_over_density|time.step|reference_error_max|labels|",
     .picture = {{"map.png"}}},
    {"feasibility", "Feasibility map: which sheets look like cloth", "sweep feasibility",
     .file = {"sweep_feasibility/table.csv", "sweep_feasibility.csv"},
     .folder = "sweep_feasibility", .picture = {{"map.png"}}},
    {"peers", "Other people's simulators", "peers/run all",
     .file = {"peers/baselines.csv", "../peers/baselines.csv"}},
    {"protocols", "Other simulators, verdict by verdict", "peers/run NAME --protocol --keep",
     .show = "protocols", .file = {"peers/protocol.csv", "../peers/protocol.csv"}},
    /* clang-format on */
    {0},
};

/* Writes the path of the part's n-th file in the folder; "" behind the last, and where the
 * path is too long. */
static void path_of(const struct report_part *part, int n, const char *folder,
                    char path[PATH])
{
    int size = PATH;

    if (part->file[n])
        size = snprintf(path, PATH, "%s/%s", folder, part->file[n]);
    else if (!part->file[0])
        size = snprintf(path, PATH, n ? "%s/%s.csv" : "%s/%s/" KEPT_NAME, folder, part->id);
    if (size >= PATH)
        *path = '\0';
}

/* Returns whether the file's folder is marked as that of a quick run. */
static bool is_quick(const char *path)
{
    char folder[PATH];

    snprintf(folder, sizeof folder, "%s", path);
    char *end = strrchr(folder, '/');
    if (end)
        *end = '\0';
    return judge_marked(folder);
}

static enum status read_one(const char *path, struct report_found *found)
{
    struct csv *csv = &found->csv[found->files];
    struct message why = {""};
    enum status st = csv_read(path, csv, &why);

    if (st == STATUS_OK && !csv->count)
        snprintf(why.text, sizeof why.text, "%.900s has no table in it", path);
    if (*why.text && !*found->trouble)
        snprintf(found->trouble, sizeof found->trouble, "%s", why.text);
    if (st != STATUS_OK)
        return st == STATUS_MEMORY ? st : STATUS_OK;
    found->files++;
    const size_t count = (size_t)(found->tables + csv->count) + 1;
    const struct csv_table **more = realloc(found->table, count * sizeof *more);
    if (!more)
        return STATUS_MEMORY;
    found->table = more;
    for (int n = 0; n < csv->count; n++)
        found->table[found->tables++] = &csv->table[n];
    return STATUS_OK;
}

static int is_csv(const struct dirent *entry)
{
    const size_t size = strlen(entry->d_name);

    return size > 4 && !strcmp(entry->d_name + size - 4, ".csv");
}

/* Reads all tables of a folder whose path ends in '/', by name. */
static enum status read_folder(const char *folder, struct report_found *found)
{
    struct dirent **entry = NULL;
    const int count = scandir(folder, &entry, is_csv, alphasort);
    char path[PATH];
    enum status st = STATUS_OK;

    found->there = count > 0;
    for (int n = 0; n < count; n++) {
        if (st == STATUS_OK && found->files < REPORT_MANY &&
            snprintf(path, sizeof path, "%s%s", folder, entry[n]->d_name) <
                (int)sizeof path)
            st = read_one(path, found);
        free(entry[n]);
    }
    free(entry);
    return st;
}

enum status report_part_find(const char *folder, const struct report_part *part,
                             struct report_found *found)
{
    enum status st = STATUS_OK;

    *found = (struct report_found){0};
    for (int n = 0; n < REPORT_FILES && !found->there; n++) {
        path_of(part, n, folder, found->path);
        if (*found->path && found->path[strlen(found->path) - 1] == '/')
            TRY(read_folder(found->path, found));
        else if ((found->there = access(found->path, F_OK) == 0))
            TRY(read_one(found->path, found));
    }
    found->quick = found->there && is_quick(found->path);
    if (found->tables) /* or the command above it says so */
        found->quick |= strstr(found->table[0]->caption, " --quick ") != NULL;
out:
    return st;
}

void report_part_clear(struct report_found *found)
{
    for (int n = 0; n < found->files; n++)
        csv_clear(&found->csv[n]);
    free(found->table);
    *found = (struct report_found){0};
}

const struct report_found *report_part_found(const struct report_found *found,
                                             const char *id)
{
    int n = 0;

    while (strcmp(report_part_list[n].id, id) != 0)
        n++;
    return &found[n];
}

const struct csv_table *report_part_table(const struct report_found *found,
                                          const char *words)
{
    for (int n = 0; n < found->tables; n++)
        if (strstr(found->table[n]->caption, words))
            return found->table[n];
    return NULL;
}

void report_part_write(FILE *file, const struct report_part *part,
                       const struct report_found *found)
{
    fputc('{', file);
    report_json_pair(file, "id", part->id);
    report_json_pair(file, "title", part->title);
    report_json_pair(file, "command", part->command);
    report_json_pair(file, "show", part->show ? part->show : "tables");
    report_json_pair(file, "trouble", found->trouble);
    report_json_pair(file, "path", found->there ? found->path : "");
    fprintf(file, "\"there\":%s,\"quick\":%s,\"tables\":[", found->there ? "true" : "false",
            found->quick ? "true" : "false");
    for (int n = 0; n < found->tables; n++) {
        fputs(n ? "," : "", file);
        report_json_table(file, found->table[n], part->keys, TABLE_MOST);
    }
    fputs("]}", file);
}

/* Reads a picture that is whole, *bytes is freed by the receiver; NULL: there is none, or
 * *why says what is wrong with it. */
static enum status read_picture(const char *path, unsigned char **bytes, size_t *size,
                                struct message *why)
{
    static const unsigned char sign[8] = "\x89PNG\r\n\x1a\n",
                               end[8] = "IEND\xae\x42\x60\x82";
    const char *reason;
    FILE *file = input_file_open(path, &reason);
    enum status st = STATUS_OK;

    *bytes = NULL, *size = 0;
    if (!file && errno == ENOENT)
        return st;
    if (!file)
        return status_fail(why, STATUS_FILE, "%s: %s", path, reason);
    *bytes = malloc(PICTURE_MOST);
    if (!*bytes)
        TRY(STATUS_MEMORY);
    *size = fread(*bytes, 1, PICTURE_MOST, file);
    if (ferror(file))
        TRY(status_fail(why, STATUS_FILE, "%s: cannot be read", path));
    if (*size < sizeof sign + sizeof end || memcmp(*bytes, sign, sizeof sign) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is no PNG", path));
    if (*size < PICTURE_MOST && memcmp(*bytes + *size - sizeof end, end, sizeof end) != 0)
        TRY(status_fail(why, STATUS_INPUT, "%s: is cut short", path));
out:
    fclose(file);
    if (st != STATUS_OK) {
        free(*bytes);
        *bytes = NULL;
    }
    return st;
}

static enum status write_picture(FILE *file, const struct report_part *part,
                                 const char *path, const struct report_picture *picture,
                                 const char *comma, long room, long *used)
{
    struct message why = {""};
    unsigned char *bytes;
    size_t size;
    const enum status st = read_picture(path, &bytes, &size, &why);
    const long most = 4 * ((long)size + 2) / 3 + 2;

    *used = 0;
    if (st == STATUS_MEMORY || (!bytes && !*why.text))
        return st;
    fprintf(file, "%s{", comma);
    report_json_pair(file, "part", part->id);
    report_json_pair(file, "path", path);
    report_json_pair(file, "paper", picture->paper ? picture->paper : "");
    report_json_pair(file, "trouble", why.text);
    fputs("\"data\":", file);
    if (bytes && most <= room)
        report_json_bytes(file, bytes, size);
    else
        fputs("null", file);
    fputc('}', file);
    *used = bytes && most <= room ? most : 1;
    free(bytes);
    return STATUS_OK;
}

enum status report_part_pictures(FILE *file, const char *folder, long room)
{
    enum status st = STATUS_OK;
    const char *comma = "";
    char path[PATH];

    for (const struct report_part *part = report_part_list; part->id; part++)
        for (int n = 0; n < REPORT_PICTURES && part->picture[n].file; n++) {
            long used;
            if (snprintf(path, sizeof path, "%s/%s/%s", folder,
                         part->folder ? part->folder : part->id,
                         part->picture[n].file) >= (int)sizeof path)
                continue;
            TRY(write_picture(file, part, path, &part->picture[n], comma, room, &used));
            room -= used;
            comma = used ? "," : comma;
        }
out:
    return st;
}

/* The least time to an error of this share of the length is reported. */
#define ENOUGH 0.01

enum { TEXT = REPORT_SENTENCE };

/* Counts of the paper's claims, and of ours. */
struct tally {
    int all, hold, fail, ours;
};

static void write_claim(FILE *file, struct tally *tally, const struct report_part *part,
                        bool ours, const char *claim, const char *verdict, const char *text,
                        bool quick)
{
    fputs(tally->all + tally->ours ? ",{" : "{", file);
    report_json_pair(file, "part", part->id);
    report_json_pair(file, "by", ours ? "us" : "the paper");
    report_json_pair(file, "claim", claim);
    report_json_pair(file, "verdict", verdict);
    report_json_pair(file, "text", text);
    fprintf(file, "\"quick\":%s}", quick ? "true" : "false");
    tally->ours += ours;
    tally->all += !ours;
    tally->hold += !ours && !strcmp(verdict, "holds");
    tally->fail += !ours && !strcmp(verdict, "does not hold");
}

/* Writes the claims that the command itself judged; returns how many. */
static int write_kept(FILE *file, struct tally *tally, const struct report_part *part,
                      const struct report_found *found)
{
    const struct csv_table *t = report_part_table(found, KEPT_SENTENCES);

    for (int n = 0; t && n < t->rows; n++) {
        const bool ours = csv_column(t, "source") >= 0 && !*csv_words_of(t, n, "source");
        const char *turns = csv_column(t, "turns") < 0 ? "" : csv_words_of(t, n, "turns");
        char text[2048];
        snprintf(text, sizeof text, "%s%s%s", csv_words_of(t, n, "sentence"),
                 *turns ? " " : "", turns);
        write_claim(file, tally, part, ours, csv_words_of(t, n, "claim"),
                    csv_words_of(t, n, "verdict"), text, found->quick);
    }
    return t ? t->rows : 0;
}

/* Writes members of an array of JSON, {"part", "by", "claim", "verdict", "text", "quick"},
 * one a claim, and counts them. A part that was not run, or cannot be read, has one that
 * says so.
 */
static void write_claims(FILE *file, const struct report_found *found, struct tally *tally)
{
    char text[128];

    for (int n = 0; report_part_list[n].id; n++) {
        const struct report_part *part = &report_part_list[n];
        const struct report_found *f = &found[n];
        if (!part->paper)
            continue;
        if (!f->there || *f->trouble) {
            snprintf(text, sizeof text, "clothbench %.100s", part->command);
            write_claim(file, tally, part, false, part->title,
                        f->there ? "damaged" : "not run", f->there ? f->trouble : text,
                        false);
        } else if (!write_kept(file, tally, part, f)) {
            write_claim(file, tally, part, false, part->title, "cannot be judged",
                        "The file has none of the paper's sentences.", f->quick);
        }
    }
}

/* Orders runs: those that are near enough by their seconds, then others by their error. */
static int compare_points(const void *a, const void *b)
{
    const struct report_run *p = a, *q = b;
    const bool near[2] = {p->error <= ENOUGH, q->error <= ENOUGH};

    if (near[0] != near[1])
        return near[0] ? -1 : 1;
    const double x = near[0] ? p->seconds : p->error, y = near[0] ? q->seconds : q->error;
    return (x > y) - (x < y);
}

const struct csv_table *report_part_runs(const struct report_found *compare)
{
    static const char *const keys[] = {"title", "model", "seconds",
                                       "worst_rmse_over_length", "front"};

    for (int n = 0; n < compare->tables; n++) {
        size_t k = 0;
        while (k < sizeof keys / sizeof *keys &&
               csv_column(compare->table[n], keys[k]) >= 0)
            k++;
        if (k == sizeof keys / sizeof *keys)
            return compare->table[n];
    }
    return NULL;
}

int report_part_best(const struct csv_table *t, struct report_run *best)
{
    int count = 0, models = 0;

    for (int row = 0; row < t->rows; row++) {
        const struct report_run p = {
            csv_words_of(t, row, "title"), csv_words_of(t, row, "contestant"),
            csv_words_of(t, row, "model"), csv_number_of(t, row, "seconds"),
            csv_number_of(t, row, "worst_rmse_over_length")};
        if (p.seconds > 0 && p.error > 0)
            best[count++] = p;
    }
    qsort(best, (size_t)count, sizeof *best, compare_points);
    for (int n = 0; n < count; n++) {
        int k = 0;
        while (k < models && strcmp(best[k].model, best[n].model) != 0)
            k++;
        if (k == models)
            best[models++] = best[n];
    }
    return models;
}

/* Rounds to two digits. */
static double rounded(double value)
{
    char text[32];

    snprintf(text, sizeof text, "%.1e", value);
    return strtod(text, NULL);
}

static void tell_claims(const struct tally *t, char text[TEXT])
{
    const int left = t->all - t->hold - t->fail;
    char more[64] = ".", ours[64] = "";

    if (left)
        snprintf(more, sizeof more, "; %d were not judged or not run.", left);
    if (t->ours)
        snprintf(ours, sizeof ours, " %d claims of ours stand beside them.", t->ours);
    snprintf(text, TEXT, "Of the paper\u2019s %d claims %d hold and %d do not%s%s", t->all,
             t->hold, t->fail, more, ours);
}

static void tell_speed(const struct report_run *best, int models, char text[TEXT])
{
    char next[160] = ".";

    if (!models || best->error > ENOUGH) {
        snprintf(text, TEXT, "No run of edge_drop comes within 1 %% of the length.");
        return;
    }
    if (models > 1 && best[1].error <= ENOUGH)
        snprintf(next, sizeof next, "; the next model, %.80s, takes %.15g times as long.",
                 best[1].title, rounded(best[1].seconds / best->seconds));
    snprintf(text, TEXT,
             "The least time to an error of 1 %% of the length on edge_drop is %.15g s, by "
             "%.80s%s",
             rounded(best->seconds), best->title, next);
}

static void tell_checks(const struct report_found *verify, char text[TEXT])
{
    int met = 0, missed = 0;

    for (int n = 0; n < verify->tables; n++) {
        const struct csv_table *t = verify->table[n];
        for (int row = 0; row < t->rows; row++) {
            const char *verdict = csv_words_of(t, row, "verdict");
            met += !strcmp(verdict, "met");
            missed += !strcmp(verdict, "MISSED") || !strcmp(verdict, "died");
        }
    }
    snprintf(text, TEXT,
             "Of the results that claim an accuracy and were compared with closed forms "
             "and other programs, %d have it and %d do not.",
             met, missed);
}

/* Tells of runs of scenes with contact: rows of a run follow one another, a time each. */
static void tell_contact(const struct report_found *touching, char text[TEXT])
{
    static const char *const keys[] = {"study", "level"};
    const struct csv_table *t = touching->table[0];
    int runs = 0, through = 0;
    bool crossed = false;
    double deepest = 0;

    for (int row = 0, last = -1; row < t->rows; row++) {
        const double crossings = csv_number_of(t, row, "crossings");
        bool same = last >= 0;
        for (int k = 0; k < 2 && same; k++)
            same = !strcmp(csv_words_of(t, row, keys[k]), csv_words_of(t, last, keys[k]));
        if (isnan(crossings)) /* dead, or refused */
            continue;
        crossed = same && crossed;
        through += crossings > 0 && !crossed;
        crossed |= crossings > 0;
        runs += !same;
        deepest = fmax(deepest, csv_number_of(t, row, "penetration"));
        last = row;
    }
    snprintf(text, TEXT,
             "In %d of %d runs of scenes with contact a sheet passes through itself or "
             "another; a body is at most %.15g mm deep in a sheet.",
             through, runs, rounded(1000 * deepest));
}

enum status report_part_summary(FILE *file, const struct report_found *found,
                                char said[REPORT_SENTENCES][REPORT_SENTENCE])
{
    const struct report_found *verify = report_part_found(found, "verify"),
                              *touching = report_part_found(found, "study_touching");
    const struct csv_table *speed = report_part_runs(report_part_found(found, "compare"));
    struct report_run *best =
        malloc(((size_t)(speed ? speed->rows : 0) + 1) * sizeof *best);
    struct tally claims = {0};

    if (!best)
        return STATUS_MEMORY;
    fputs("\"claims\":[", file);
    write_claims(file, found, &claims);
    fputs("],", file);
    const int models = speed ? report_part_best(speed, best) : 0;
    tell_claims(&claims, said[0]);
    if (speed)
        tell_speed(best, models, said[1]);
    else
        snprintf(said[1], TEXT,
                 "Speed against error was not measured: clothbench compare edge_drop");
    if (verify->tables)
        tell_checks(verify, said[2]);
    else
        snprintf(said[2], TEXT,
                 "Nothing was compared with closed forms: clothbench verify");
    if (touching->tables)
        tell_contact(touching, said[3]);
    else
        snprintf(said[3], TEXT, "Contact was not run: clothbench study touching");
    fputs("\"found\":", file);
    for (int n = 0; n < REPORT_SENTENCES; n++) {
        fputc(n ? ',' : '[', file);
        report_json_string(file, said[n]);
    }
    fputs("],", file);
    free(best);
    return STATUS_OK;
}
