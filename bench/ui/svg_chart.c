#include "bench/ui/svg_chart.h"

#include <math.h>

#include "bench/ui/html.h"

/* Size of the drawing, and where its axes are [px]. */
enum { WIDTH = 420, HEIGHT = 276, LEFT = 66, RIGHT = 410, TOP = 8, BOTTOM = 238 };

enum { COLOURS = 8 };

/* The axis of errors begins at the largest of them over this. */
static const double RANGE = 1e3;

/* The ratio of the ends of an axis from which on its tics are powers of ten. */
static const double DECADES = 100;

/* The ends of both axes. */
struct frame {
    double x[2], y[2];
    bool log_x;
};

static struct frame frame_of(bool log_x, int lines, const struct svg_chart_line *line)
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

static void draw_tic(const struct frame *f, double x, FILE *file)
{
    const double at = x_of(f, x);

    fprintf(file,
            "<line x1=\"%.1f\" x2=\"%.1f\" y1=\"%d\" y2=\"%d\"/><text x=\"%.1f\" y=\"%d\" "
            "text-anchor=\"middle\">%g</text>\n",
            at, at, TOP, BOTTOM, at, BOTTOM + 16, x);
}

static void draw_axes(const struct frame *f, const char *name, FILE *file)
{
    const double ten = pow(10, floor(log10(f->x[1] / 2)));
    const bool decades = f->log_x && f->x[1] > DECADES * f->x[0];

    for (double y = f->y[0]; y <= f->y[1] * (1 + 1e-9); y *= 10)
        fprintf(file,
                "<line x1=\"%d\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\"/><text x=\"%d\" "
                "y=\"%.1f\" text-anchor=\"end\">%g %%</text>\n",
                LEFT, RIGHT, y_of(f, y), y_of(f, y), LEFT - 5, y_of(f, y) + 4, y);
    for (int n = 0; !decades && n * ten <= f->x[1] * (1 + 1e-9); n++)
        if (n * ten >= f->x[0])
            draw_tic(f, n * ten, file);
    for (int n = (int)ceil(log10(f->x[0])); decades && n <= log10(f->x[1]); n++)
        draw_tic(f, pow(10, n), file);
    fprintf(file, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n",
            (LEFT + RIGHT) / 2, BOTTOM + 34, name);
}

/* Writes the class of the n-th line's colour. */
static void put_class(int n, const struct svg_chart_line *line, FILE *file)
{
    if (line->bar)
        fputs("class=\"area\"", file);
    else
        fprintf(file, "class=\"c%d\"", n % COLOURS);
}

/* Draws a line with its points, or the area below it. */
static void draw_line(const struct frame *f, int n, const struct svg_chart_line *line,
                      FILE *file)
{
    const double(*const xy)[2] = line->xy;

    fputs("<path ", file);
    put_class(n, line, file);
    fputs(" d=\"M", file);
    if (line->bar)
        fprintf(file, "%.1f %dL", x_of(f, xy[0][0]), BOTTOM);
    for (int k = 0; k < line->count; k++)
        fprintf(file, "%s%.1f %.1f", k ? "L" : "", x_of(f, xy[k][0]), y_of(f, xy[k][1]));
    if (line->bar)
        fprintf(file, "L%.1f %dZ", x_of(f, xy[line->count - 1][0]), BOTTOM);
    fputs("\"/>\n", file);
    for (int k = 0; k < line->count && !line->bar; k++) {
        fputs("<circle ", file);
        put_class(n, line, file);
        fprintf(file, " cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\">", x_of(f, xy[k][0]),
                y_of(f, xy[k][1]));
        html_print(file, "<title>%s%s%s, ", line->label, *line->note[k] ? ", " : "",
                   line->note[k]);
        fprintf(file, "%.3g: %.3g %%</title></circle>\n", xy[k][0], xy[k][1]);
    }
}

static void put_legend(int n, const struct svg_chart_line *line, FILE *file)
{
    fputs("<span style=\"display:inline-block;margin-right:1em\"><b ", file);
    put_class(n, line, file);
    fputs(line->bar ? ">&#9632;</b> " : ">&#9679;</b> ", file);
    if (*line->link)
        html_print(file, "<a href=\"%s\">%s</a></span>\n", line->link, line->label);
    else
        html_print(file, "%s</span>\n", line->label);
}

void svg_chart_write(const char *title, const char *x_name, bool log_x, int lines,
                     const struct svg_chart_line *line, FILE *file)
{
    const struct frame f = frame_of(log_x, lines, line);

    fputs("<figure>", file);
    if (title)
        html_print(file, "<figcaption>%s</figcaption>\n", title);
    fprintf(file, "<svg class=\"chart\" viewBox=\"0 0 %d %d\" role=\"img\">\n", WIDTH,
            HEIGHT);
    draw_axes(&f, x_name, file);
    for (int n = 0; n < lines; n++)
        draw_line(&f, n, &line[n], file);
    fputs("</svg>\n<p class=\"soft\">", file);
    for (int n = 0; n < lines; n++)
        put_legend(n, &line[n], file);
    fputs("</p></figure>\n", file);
}
