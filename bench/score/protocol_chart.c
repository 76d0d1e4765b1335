#include "bench/score/protocol_chart.h"

#include <math.h>

#include "bench/ui/table.h"

/* Size of the drawing, and where its axes are [px]. */
enum { WIDTH = 420, HEIGHT = 276, LEFT = 66, RIGHT = 410, TOP = 8, BOTTOM = 238 };

/* Colours, which the page's style names c0, c1, ... */
enum { COLOURS = 6 };

/* The axis of errors begins at the largest of them over this. */
static const double RANGE = 1e3;

/* The ends of both axes. */
struct frame {
    double x[2], y[2];
    bool log_x;
};

static struct frame frame_of(bool log_x, int lines, const struct protocol_line *line)
{
    struct frame f = {{INFINITY, 0}, {INFINITY, 0}, log_x};

    for (int n = 0; n < lines; n++)
        for (int k = 0; k < line[n].count; k++) {
            const double *p = line[n].xy[k];
            f.x[0] = fmin(f.x[0], p[0]), f.x[1] = fmax(f.x[1], p[0]);
            f.y[0] = p[1] > 0 ? fmin(f.y[0], p[1]) : f.y[0], f.y[1] = fmax(f.y[1], p[1]);
        }
    if (!(f.y[1] > 0))
        f.y[0] = f.y[1] = 1;
    f.y[0] = pow(10, floor(log10(fmax(f.y[0], f.y[1] / RANGE))));
    f.y[1] = fmax(pow(10, ceil(log10(f.y[1]))), 10 * f.y[0]);
    f.x[0] = log_x ? f.x[0] / 1.2 : 0;
    f.x[1] = log_x ? f.x[1] * 1.2 : f.x[1];
    return f;
}

static double x_of(const struct frame *f, double x)
{
    const double s = f->log_x ? log10(x / f->x[0]) / log10(f->x[1] / f->x[0])
                              : (x - f->x[0]) / (f->x[1] - f->x[0]);

    return LEFT + s * (RIGHT - LEFT);
}

static double y_of(const struct frame *f, double y)
{
    const double s = log10(fmax(y, f->y[0]) / f->y[0]) / log10(f->y[1] / f->y[0]);

    return BOTTOM + s * (TOP - BOTTOM);
}

static void draw_axes(const struct frame *f, const char *name, FILE *file)
{
    const double ten = pow(10, floor(log10(f->x[1] / 2)));

    for (double y = f->y[0]; y <= f->y[1] * (1 + 1e-9); y *= 10)
        fprintf(file,
                "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\"/><text x=\"%d\" "
                "y=\"%.1f\" text-anchor=\"end\">%g %%</text>\n",
                LEFT, RIGHT, y_of(f, y), y_of(f, y), LEFT - 5, y_of(f, y) + 4, y);
    for (int n = 0; n * ten <= f->x[1] * (1 + 1e-9); n++)
        if (n * ten >= f->x[0])
            fprintf(file,
                    "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/><text x=\"%.1f\" "
                    "y=\"%d\" text-anchor=\"middle\">%g</text>\n",
                    x_of(f, n * ten), x_of(f, n * ten), TOP, BOTTOM, x_of(f, n * ten),
                    BOTTOM + 16, n * ten);
    fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n",
            (LEFT + RIGHT) / 2, BOTTOM + 34, name);
}

/* Draws a line with its points, or the area below it. */
static void draw_line(const struct frame *f, const struct protocol_line *line, int colour,
                      FILE *file)
{
    const double(*const xy)[2] = line->xy;

    fprintf(file, "<path class=\"c%d\" d=\"M", colour);
    if (line->bar)
        fprintf(file, "%.1f %dL", x_of(f, xy[0][0]), BOTTOM);
    for (int k = 0; k < line->count; k++)
        fprintf(file, "%s%.1f %.1f", k ? "L" : "", x_of(f, xy[k][0]), y_of(f, xy[k][1]));
    if (line->bar)
        fprintf(file, "L%.1f %dZ", x_of(f, xy[line->count - 1][0]), BOTTOM);
    fputs("\"/>\n", file);
    for (int k = 0; k < line->count && !line->bar; k++) {
        fprintf(file, "<circle class=\"c%d\" cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\"><title>",
                colour, x_of(f, xy[k][0]), y_of(f, xy[k][1]));
        table_html_text(line->label, file);
        fprintf(file, ", %g: %.3g %%</title></circle>\n", xy[k][0], xy[k][1]);
    }
}

void protocol_chart_write(const char *title, const char *x_name, bool log_x, int lines,
                          const struct protocol_line *line, FILE *file)
{
    const struct frame f = frame_of(log_x, lines, line);

    fputs("<figure><figcaption>", file);
    table_html_text(title, file);
    fprintf(file, "</figcaption>\n<svg viewBox=\"0 0 %d %d\" role=\"img\">\n", WIDTH,
            HEIGHT);
    draw_axes(&f, x_name, file);
    for (int n = 0; n < lines; n++)
        draw_line(&f, &line[n], line[n].bar ? COLOURS : n % COLOURS, file);
    fputs("</svg>\n<p class=\"soft\">", file);
    for (int n = 0; n < lines; n++) {
        fprintf(file, "<span class=\"c%d\">%s</span>&nbsp;",
                line[n].bar ? COLOURS : n % COLOURS, line[n].bar ? "&#9632;" : "&#9679;");
        table_html_text(line[n].label, file);
        fputs(" &ensp;", file);
    }
    fputs("</p></figure>\n", file);
}
