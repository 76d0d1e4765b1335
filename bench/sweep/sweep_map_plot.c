#include "bench/sweep/sweep_map_plot.h"

#include <stdio.h>
#include <string.h>

#include "bench/files/output.h"

/* Whether a name kept is this one, as far as it was kept; quotes were not. */
static bool is_name(const char *kept, const char *name)
{
    for (int n = 0; n < SWEEP_MAP_NAME - 1; n++) {
        if (kept[n] != (strchr("'\"", name[n]) && name[n] ? ' ' : name[n]))
            return false;
        if (!name[n])
            break;
    }
    return true;
}

int sweep_map_names_add(struct sweep_map_names *names, const char *name)
{
    const int last = SWEEP_MAP_NAMES - 1;

    for (int n = 0; n < names->count; n++)
        if (is_name(names->name[n], name)) {
            names->uses[n]++;
            return n;
        }
    if (names->count <= last) {
        char *text = names->name[names->count++];
        snprintf(text, SWEEP_MAP_NAME, "%s", names->count > last ? "other" : name);
        while ((text = strpbrk(text, "'\"")))
            *text = ' '; /* they would end a string of gnuplot's */
    }
    names->uses[names->count - 1]++;
    return names->count - 1;
}

/* What is good is green, what has no result grey; the rest are told apart by eyes of all
 * kinds. */
static const char *colour_of(const char *class, int n)
{
    static const struct {
        const char *class, *colour;
    } known[] = {
        {"feasible", "#8cd17d"},  {"accurate", "#8cd17d"},    {"reference", "#c9e8c0"},
        {"degraded", "#edc948"},  {"died", "#444444"},        {"refused", "#d9d9d9"},
        {"no result", "#d9d9d9"}, {"unsupported", "#d9d9d9"},
    };
    static const char *const palette[] = {
        "#e15759", "#f28e2b", "#edc948", "#4e79a7", "#b07aa1", "#76b7b2", "#9c755f",
        "#ff9da7", "#a0cbe8", "#d37295", "#b6992d", "#d4a6c8", "#fabfd2", "#79706e",
    };
    enum { COLOURS = sizeof palette / sizeof *palette };

    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (!strcmp(class, known[k].class))
            return known[k].colour;
    return palette[(n + COLOURS - 1) % COLOURS];
}

/* Point types of marks, told apart without colour. */
static int type_of(int mark)
{
    static const int types[] = {7, 9, 5, 13, 11, 15, 6, 8, 4, 12};
    return types[mark % 10];
}

static void write_side(struct output *out, char axis, const struct sweep_map_side *side)
{
    output_print(out, "set %clabel '%s'\n", axis, side->name);
    if (side->log)
        output_print(out, "set logscale %c\n", axis);
    if (*side->tics)
        output_print(out, "set %ctics %s\n", axis, side->tics);
    else
        output_print(out, "set format %c '%%g'\n", axis);
}

static void write_marks(struct output *out, const struct sweep_map_plot *p, int panel)
{
    for (int m = 0; m < p->marks->count; m++)
        if (p->marked[panel][m])
            output_print(out,
                         "'marks.dat' using (($1 < 0 || $1 == %d) && $2 == %d ? $3 : "
                         "NaN):4 with points pt %d ps 1.4 lc rgb 'black' notitle, \\\n"
                         "'' using (($1 < 0 || $1 == %d) && $2 == %d ? $3 : NaN):4:5 with "
                         "labels offset 0,0.8 font ',9' notitle, \\\n",
                         panel, m, type_of(m), panel, m);
}

static void write_panel(struct output *out, const struct sweep_map_plot *p, int panel)
{
    if (p->panel && !strcmp(p->panel, "name"))
        output_print(out, "set title '%s'\n", p->panels->name[panel]);
    else if (p->panel)
        output_print(out, "set title '%s = %s'\n", p->panel, p->panels->name[panel]);
    else
        output_print(out, "set title '%s'\n", p->title);
    output_print(out, "plot \\\n");
    for (int c = 0; c < p->classes->count; c++) {
        const char *colour = colour_of(p->classes->name[c], c);
        if (!p->seen[panel][c])
            continue;
        output_print(out, "'map.dat' using ($1 == %d && $2 == %d ? $3 : NaN):4", panel, c);
        if (p->cells)
            output_print(out,
                         ":5:6:7:8 with boxxyerror fs solid 1 border lc rgb '%s' "
                         "lc rgb '%s' notitle, \\\n",
                         colour, colour);
        else
            output_print(out, " with points pt 7 ps 1.5 lc rgb '%s' notitle, \\\n", colour);
    }
    write_marks(out, p, panel);
    output_print(out, "NaN notitle\n");
}

/* An empty plot that holds the key for all panels. */
static void write_legend(struct output *out, const struct sweep_map_plot *p)
{
    output_print(out, "unset logscale\nunset border\nunset tics\nunset xlabel\n"
                      "unset ylabel\nunset title\nset key font ',10' Left reverse "
                      "at graph -0.1, graph 1 left top\n"
                      "plot [0:1][0:1] \\\n");
    for (int c = 0; c < p->classes->count; c++)
        output_print(out, "NaN with points pt 5 ps 2.5 lc rgb '%s' title '%s: %ld', \\\n",
                     colour_of(p->classes->name[c], c), p->classes->name[c],
                     p->classes->uses[c]);
    for (int m = 0; m < p->marks->count; m++)
        output_print(out,
                     "NaN with points pt %d ps 1.4 lc rgb 'black' title '%s: %ld', "
                     "\\\n",
                     type_of(m), p->marks->name[m], p->marks->uses[m]);
    output_print(out, "NaN notitle\n");
}

enum status sweep_map_plot(const char *folder, const struct sweep_map_plot *p,
                           struct message *why)
{
    const int plots = (p->panels->count ? p->panels->count : 1) + 1;
    const int columns = plots < 4 ? plots : plots < 7 ? 3 : 4;
    const int rows = (plots + columns - 1) / columns;
    struct output *out = NULL;
    char path[4096];
    enum status st;

    snprintf(path, sizeof path, "%s/map.gp", folder);
    TRY(output_create(path, &out, why));
    output_print(out,
                 "set terminal pngcairo noenhanced size %d,%d\nset output 'map.png'\n"
                 "set multiplot layout %d,%d title '%s'\nset datafile missing NaN\n"
                 "set tics out nomirror\nset autoscale fix\nunset key\n",
                 520 * columns, 460 * rows + 40, rows, columns, p->title);
    write_side(out, 'x', &p->x);
    write_side(out, 'y', &p->y);
    for (int n = 0; n < plots - 1; n++)
        write_panel(out, p, n);
    write_legend(out, p);
    output_print(out, "unset multiplot\n");
    return output_close(out, why);
out:
    return st;
}
