/* chart_look.c - colours, points and dashes. */
#include "bench/ui/chart_parts.h"

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
        if (legend)
            output_print(out, " with points pt 5 ps scale*2");
        else if (item->as.style == CHART_BAND)
            output_print(out, " with filledcurves fs transparent solid 0.3 noborder");
        else
            output_print(out, " with boxxyerror fs solid 1 border lc rgb '%s'", rgb);
    }
    output_print(out, " lc rgb ");
    plot_text(out, rgb);
}
