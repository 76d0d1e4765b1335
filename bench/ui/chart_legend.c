/* chart_legend.c - what stands below the panels, a label once. */
#include "bench/ui/chart_parts.h"

#include <string.h>

#include "bench/ui/plot.h"

enum { KEY = 70 }; /* points for the picture of a line or point, and the room around */

static void add_entry(struct chart_legend *l, struct chart_entry entry)
{
    for (int n = 0; n < l->count; n++)
        if (!strcmp(l->entry[n].label, entry.label))
            return;
    if (l->count < CHART_ENTRIES)
        l->entry[l->count++] = entry;
}

/* Characters of a label: bytes that do not continue one of UTF-8. */
static int width_of(const char *text)
{
    int width = 0;

    for (; *text; text++)
        width += (*text & 0xc0) != 0x80;
    return width;
}

struct chart_legend chart_legend_of(const struct chart *c, int width)
{
    struct chart_legend l = {0};
    int widest = 1;

    for (int p = 0; p < c->pane_count; p++) {
        const struct chart_pane *pane = &c->pane[p];
        for (int n = 0; n < pane->item_count; n++)
            if (pane->item[n].as.label)
                add_entry(&l, (struct chart_entry){pane->item[n].as.label, &pane->item[n],
                                                   false});
        for (int n = 0; n < pane->stripe_count; n++)
            if (pane->stripe[n].label)
                add_entry(
                    &l, (struct chart_entry){pane->stripe[n].label, NULL,
                                             pane->stripe[n].low == pane->stripe[n].high});
    }
    for (int n = 0; n < l.count; n++)
        if (width_of(l.entry[n].label) > widest)
            widest = width_of(l.entry[n].label);
    l.columns = (width - 40) / (KEY + CHART_CHARACTER * widest);
    if (l.columns < 1)
        l.columns = 1;
    l.rows = (l.count + l.columns - 1) / l.columns;
    if (l.rows) /* as even as it can be */
        l.columns = (l.count + l.rows - 1) / l.rows;
    return l;
}

void chart_legend_write(struct output *out, const struct chart_legend *l)
{
    output_print(out,
                 "unset object\nunset arrow\nunset label\nunset logscale\nunset border\n"
                 "unset tics\nunset grid\nunset title\nunset xlabel\nunset ylabel\n"
                 "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                 "set key center center horizontal maxcols %d Left reverse samplen 3\n"
                 "plot [0:1][0:1] \\\n",
                 l->columns);
    for (int n = 0; n < l->count; n++) {
        output_print(out, "NaN");
        if (l->entry[n].item)
            chart_look_write(out, l->entry[n].item, true);
        else if (l->entry[n].line)
            output_print(out, " with lines lw 1.5 dt (6,4) lc rgb '#808080'");
        else
            output_print(out, " with points pt 5 ps scale*2 lc rgb '%s'", chart_look_band);
        output_print(out, " title ");
        plot_text(out, l->entry[n].label);
        output_print(out, ", \\\n");
    }
    output_print(out, "NaN notitle\n");
}
