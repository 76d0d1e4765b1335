#include "tests/calculix_store.h"

#include <time.h>

#include "fem_ref/calculix_deck.h"
#include "tests/calculix_cases.h"
#include "tests/check.h"

static FILE *begin(const char *folder, const char *name, const char *what)
{
    char path[512], date[16];
    time_t now = time(NULL);
    snprintf(path, sizeof path, "%s/calculix_%s.csv", folder, name);
    FILE *file = fopen(path, "w");
    REQUIRE(file && strftime(date, sizeof date, "%Y-%m-%d", gmtime(&now)));
    fprintf(file,
            "# %s, by CalculiX.\n"
            "# Computed for this project by `test_calculix_truth store FOLDER`; deck by "
            "fem_ref/calculix_deck.c.\n"
            "# command: ccx -i job, one thread\n# date: %s\n",
            what, date);
    return file;
}

static void write_job(FILE *file, const struct calculix_job *job,
                      const struct calculix_answer *answer)
{
    char hash[17];
    REQUIRE(!calculix_deck_hash(job, hash));
    fprintf(file,
            "# calculix: %s\n# deck_fnv1a: %s\n# element: %s\n# cells: %d %d %d\n"
            "# length: %.17g\n# width: %.17g\n# thickness: %.17g\n# young: %.17g\n"
            "# poisson: %.17g\n# density: %.17g\n# gravity: %.17g\n",
            answer->version, hash, calculix_element_name(job->element), job->cells[0],
            job->cells[1], job->cells[2], job->length, job->width, job->thickness,
            job->young, job->poisson, job->density, job->gravity);
}

static void store_matrices(const char *folder, int n)
{
    struct calculix_job job = cases_matrix_job(n);
    struct calculix_answer a = cases_run(&job);
    char name[64];
    snprintf(name, sizeof name, "matrices_%s", cases_matrices[n].name);
    FILE *file = begin(folder, name,
                       "Stiffness and consistent mass of a free block, lower triangle, row "
                       "= 3 ((i m + j) l + k) + component");

    write_job(file, &job, &a);
    fprintf(file, "row,column,stiffness,mass\n");
    REQUIRE(a.K.entries == a.M.entries);
    for (long t = 0; t < a.K.entries; t++) {
        REQUIRE(a.K.row[t] == a.M.row[t] && a.K.column[t] == a.M.column[t]);
        if (a.K.value[t] != 0 || a.M.value[t] != 0)
            fprintf(file, "%d,%d,%.13e,%.13e\n", a.K.row[t], a.K.column[t], a.K.value[t],
                    a.M.value[t]);
    }
    REQUIRE(!fclose(file));
    calculix_clear(&a);
}

static void store_tips(const char *folder)
{
    FILE *file =
        begin(folder, "tips",
              "Fall of the free edge's middle and corner [m]: square cantilever under its "
              "own weight, small strain");

    for (int n = 0; n < CASES_TIPS; n++) {
        struct calculix_job job = cases_tip_job(n);
        struct calculix_answer a = cases_run(&job);
        int c = job.cells[0];
        char hash[17];
        REQUIRE(!calculix_deck_hash(&job, hash));
        if (n == 0)
            fprintf(file,
                    "# calculix: %s\n# young: %.17g\n# poisson: %.17g\n# density: %.17g\n"
                    "# gravity: %.17g\nelement,thickness,cells,deck_fnv1a,middle,corner\n",
                    a.version, job.young, job.poisson, job.density, job.gravity);
        fprintf(file, "%s,%.17g,%d,%s,%.6e,%.6e\n", calculix_element_name(job.element),
                job.thickness, c, hash, -calculix_shift(&a, 0, c, c / 2)[2],
                -calculix_shift(&a, 0, c, c)[2]);
        calculix_clear(&a);
    }
    REQUIRE(!fclose(file));
}

/* Largest distance of two swings at the free edge; the coarser's times. */
static double apart(const struct calculix_answer *a, const struct calculix_answer *b)
{
    double most = 0;
    for (int t = 0; t < a->times; t++) {
        const double *p = calculix_shift(a, t, a->points[0] - 1, 0);
        const double *q = calculix_shift(b, t, b->points[0] - 1, 0);
        most = fmax(most, hypot(p[0] - q[0], p[2] - q[2]));
    }
    return most;
}

static void store_swing(const char *folder)
{
    struct calculix_job job = cases_swing_job(20, 1e-3);
    struct calculix_job coarse = cases_swing_job(10, 1e-3);
    struct calculix_job slow = cases_swing_job(20, 2e-3);
    struct calculix_answer a = cases_run(&job), b = cases_run(&coarse),
                           c = cases_run(&slow);
    FILE *file = begin(folder, "swing_h5mm",
                       "A clamped strip swings under its own weight, nu = 0, undamped: "
                       "positions of the mid-surface [m]");

    write_job(file, &job, &a);
    fprintf(file, "# step: %g\n# mesh_error_m: %.1e\n# step_error_m: %.1e\nt", job.step,
            apart(&a, &b) / 3, apart(&a, &c) / 3); /* what second order leaves */
    for (int k = 4; k > 0; k--)
        fprintf(file, ",x%.2f,z%.2f", k / 4.0, k / 4.0);
    fprintf(file, "\n");
    for (int t = 0; t < a.times; t++) {
        fprintf(file, "%.2f", a.time[t]);
        for (int k = 4; k > 0; k--) {
            const double *x = calculix_shift(&a, t, job.cells[0] * k / 4, 0);
            fprintf(file, ",%.9f,%.9f", k / 4.0 + x[0], x[2]);
        }
        fprintf(file, "\n");
    }
    REQUIRE(!fclose(file));
    calculix_clear(&a);
    calculix_clear(&b);
    calculix_clear(&c);
}

void calculix_store(const char *folder)
{
    for (int n = 0; n < CASES_MATRICES; n++)
        store_matrices(folder, n);
    store_tips(folder);
    store_swing(folder);
}
