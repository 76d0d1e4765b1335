#include "bench/ui/progress.h"

#include <stdio.h>
#include <unistd.h>

#include "models/clock.h"

enum { BAR_WIDTH = 30 };

static const double redraw_seconds = 0.1;

struct progress progress_start(const char *label, long total, bool quiet)
{
    double now = clock_now();
    return (struct progress){.label = label,
                             .total = total,
                             .start = now,
                             .shown = now,
                             .on = !quiet && total > 0 && isatty(STDERR_FILENO)};
}

void progress_update(struct progress *p, long done)
{
    if (!p->on || done <= 0)
        return;
    double now = clock_now();
    if (now - p->shown < redraw_seconds)
        return;
    double share = (double)done / (double)p->total;
    double left = (now - p->start) * (1 - share) / share;
    int filled = (int)(share * BAR_WIDTH);

    fprintf(stderr, "\r%s [", p->label);
    for (int n = 0; n < BAR_WIDTH; n++)
        fputc(n < filled ? '#' : '.', stderr);
    fprintf(stderr, "] %3.0f %%, %.0f s left\033[K", 100 * share, left);
    fflush(stderr);
    p->shown = now;
    p->drawn = true;
}

void progress_end(struct progress *p)
{
    if (p->drawn)
        fputs("\r\033[K", stderr);
    p->on = p->drawn = false;
}
