/* chart_look.c - colours, points and dashes, and the legend that tells them. */
#include "bench/ui/chart_parts.h"

#include <string.h>

#include "bench/ui/plot.h"

/* Told apart by all kinds of eyes (Okabe and Ito); in grey by points and dashes. */
static const struct look {
    const char *rgb;
    int filled, open; /* points */
    const char *dash;
} looks[] = {{"#0072b2", 7, 6, "solid"},    {"#d55e00", 5, 4, "(14,5)"},
             {"#009e73", 9, 8, "(4,4)"},    {"#cc79a7", 13, 12, "(14,4,3,4)"},
             {"#000000", 11, 10, "(22,5)"}, {"#e69f00", 15, 14, "(8,8)"},
             {"#56b4e9", 3, 2, "(3,8)"},    {"#7f7f7f", 1, 1, "(14,4,3,4,3,4)"}};
enum { LOOKS = sizeof looks / sizeof *looks };

const char chart_look_band[] = "#c8c8c8";

/* Beyond the looks there are all of them once more, dashed and open. */
static bool is_second(const struct chart_item *item)
{
    return item->as.second || item->look / LOOKS % 2;
}

const char *chart_look_rgb(const struct chart_item *item)
{
    return item->as.rgb ? item->as.rgb : looks[item->look % LOOKS].rgb;
}

void chart_look_write(struct output *out, const struct chart_item *item, bool legend)
{
    const struct look *look = &looks[item->look % LOOKS];
    const bool second = is_second(item);
    const int type = second ? look->open : look->filled;
    const char *rgb = chart_look_rgb(item);

    switch (item->as.style) {
    case CHART_LINESPOINTS:
        output_print(out, " with linespoints lw 1.6 dt %s pt %d ps scale*1.1",
                     second ? "(10,6)" : "solid", type);
        break;
    case CHART_LINE:
        output_print(out, " with lines lw 1.8 dt %s", second ? "(3,3)" : look->dash);
        break;
    case CHART_STEPS:
        output_print(out, " with %s lw 1.8 dt %s", legend ? "lines" : "steps",
                     second ? "(3,3)" : look->dash);
        break;
    case CHART_POINTS:
        output_print(out, " with points pt %d ps scale*1.2", type);
        break;
    case CHART_DOTS:
        output_print(out, legend ? " with points pt 7 ps scale*0.6" : " with dots");
        break;
    case CHART_SQUARES:
        output_print(out, " with points pt 5 ps scale*1.6");
        break;
    case CHART_BAND:
    case CHART_CELLS:
    case CHART_HATCHED_CELLS:
        if (legend && item->as.style == CHART_HATCHED_CELLS)
            output_print(out, " with boxes fs transparent pattern 5");
        else if (legend)
            output_print(out, " with points pt 5 ps scale*2");
        else if (item->as.style == CHART_BAND)
            output_print(out, " with filledcurves fs transparent solid 0.3 noborder");
        else if (item->as.style == CHART_HATCHED_CELLS)
            output_print(out, " with boxxyerror fs transparent pattern 5 noborder");
        else
            output_print(out, " with boxxyerror fs solid 1 border lc rgb '%s'", rgb);
    }
    output_print(out, " lc rgb ");
    plot_text(out, rgb);
}

/* --- the legend ----------------------------------------------------------------------- */

enum { KEY = 70 }; /* points for the picture of a line or point, and the room around */

static bool has_entry(const struct chart_legend *l, const char *label)
{
    for (int n = 0; n < l->count; n++)
        if (!strcmp(l->entry[n]->as.label, label))
            return true;
    return false;
}

static void add_entries(struct chart_legend *l, const struct chart_list *list)
{
    for (int n = 0; n < list->count && l->count < CHART_ENTRIES; n++)
        if (list->item[n].as.label && !has_entry(l, list->item[n].as.label))
            l->entry[l->count++] = &list->item[n];
}

struct chart_legend chart_look_legend(const struct chart *c, int width)
{
    struct chart_legend l = {0};
    int widest = 1;

    for (int p = 0; p < c->pane_count; p++) {
        add_entries(&l, &c->pane[p].series);
        add_entries(&l, &c->pane[p].stripes);
    }
    for (int n = 0; n < l.count; n++)
        if (table_width(l.entry[n]->as.label) > widest)
            widest = table_width(l.entry[n]->as.label);
    l.columns = (width - 40) / (KEY + CHART_CHARACTER * widest);
    if (l.columns < 1)
        l.columns = 1;
    l.rows = (l.count + l.columns - 1) / l.columns;
    if (l.rows) /* as even as it can be */
        l.columns = (l.count + l.rows - 1) / l.rows;
    return l;
}

void chart_look_write_legend(struct output *out, const struct chart_legend *l)
{
    output_print(out,
                 "unset object\nunset arrow\nunset label\nunset logscale\nunset border\n"
                 "unset tics\nunset grid\nunset title\nunset xlabel\nunset ylabel\n"
                 "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                 "set key center center horizontal maxcols %d Left reverse samplen 3\n"
                 "plot [0:1][0:1] \\\n",
                 l->columns);
    for (int n = 0; n < l->count; n++) {
        const struct chart_item *item = l->entry[n];
        output_print(out, "NaN");
        if (!item->band)
            chart_look_write(out, item, true);
        else if (item->at->y_side[0] == item->at->y_side[1])
            output_print(out, " with lines lw 1.5 dt (6,4) lc rgb '#808080'");
        else
            output_print(out, " with points pt 5 ps scale*2 lc rgb '%s'", chart_look_band);
        output_print(out, " title ");
        plot_text(out, item->as.label);
        output_print(out, ", \\\n");
    }
    output_print(out, "NaN notitle\n");
}
