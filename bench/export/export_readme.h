/* export_readme.h - README.md of an export: the rules on one page. */
#ifndef EXPORT_README_H
#define EXPORT_README_H

#include "bench/export/export_held.h"
#include "bench/truth/truth_made.h"

struct export_readme {
    const struct export_held *held;
    const struct truth_made *known; /* no times: no truth is known                     */
    const char *misfit;             /* of the matched springs; empty: none             */
    bool undamped;                  /* the scene is damped by a factor a step          */
};

enum status export_readme_write(const struct export_sheet *s, const struct export_readme *r,
                                struct message *why);

#endif
