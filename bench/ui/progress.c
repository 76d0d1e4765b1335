#include "bench/ui/progress.h"

#include <stdio.h>
#include <unistd.h>

#include "models/clock.h"

enum { BAR_WIDTH = 30 };

static const double redraw_seconds = 0.1, line_seconds = 60;

struct progress progress_start(const char *label, long total, bool quiet)
{
    double now = clock_now();
    return (struct progress){.label = label,
                             .total = total,
                             .start = now,
                             .shown = now,
                             .on = !quiet && total > 0,
                             .terminal = isatty(STDERR_FILENO)};
}

static void draw(const char *label, double share, double left)
{
    const int filled = (int)(share * BAR_WIDTH);

    fprintf(stderr, "\r%s [", label);
    for (int n = 0; n < BAR_WIDTH; n++)
        fputc(n < filled ? '#' : '.', stderr);
    fprintf(stderr, "] %3.0f %%, %.0f s left\033[K", 100 * share, left);
    fflush(stderr);
}

void progress_update(struct progress *p, long done)
{
    const double now = clock_now();

    if (!p->on || done <= 0 ||
        now - p->shown < (p->terminal ? redraw_seconds : line_seconds))
        return;
    const double share = (double)done / (double)p->total;
    const double left = (now - p->start) * (1 - share) / share;

    if (p->terminal)
        draw(p->label, share, left);
    else
        fprintf(stderr, "%s: %.0f %%, %.0f s left\n", p->label, 100 * share, left);
    p->shown = now;
    p->drawn = p->terminal;
}

void progress_end(struct progress *p)
{
    if (p->drawn)
        fputs("\r\033[K", stderr);
    p->on = p->drawn = false;
}
