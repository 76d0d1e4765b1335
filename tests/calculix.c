/* CalculiX's decks and answers: what is written for it, and that every bad answer and
 * program is refused.
 *
 *   calculix              with programs of our own in its place
 *   calculix failures     with the real one (77 if not installed)
 */
#include "fem_ref/calculix.h"
#include "tests/scratch.h"

#include <sys/stat.h>
#include <unistd.h>

static const char *fake;
static struct calculix_answer answer;

/* One element of 8 nodes: matrices, statics, two answers of a swing. */
static struct calculix_job one(enum calculix_task task)
{
    return (struct calculix_job){.task = task,
                                 .length = 1,
                                 .width = 1,
                                 .thickness = 0.5,
                                 .cells = {1, 1, 1},
                                 .young = 1e5,
                                 .poisson = 0.25,
                                 .density = 0.5,
                                 .gravity = 9.81,
                                 .step = 0.01,
                                 .end = 0.02,
                                 .every = 1};
}

static char *deck(const struct calculix_job *job)
{
    static char text[1 << 16];
    FILE *file = fmemopen(text, sizeof text, "w");
    REQUIRE(file != NULL);
    calculix_deck_write(job, file);
    REQUIRE(!fclose(file));
    return text;
}

/* ------------------------------------------------------------------ decks ----------- */

static void check_decks(void)
{
    struct calculix_job job = one(CALCULIX_STATIC);
    char hash[2][17];
    const char *text = deck(&job);

    /* Bottom face round, then the top; k runs fastest in the numbers. */
    CHECK(strstr(text, "*ELEMENT, TYPE=C3D8, ELSET=SHEET\n1,1,5,7,3,2,6,8,4\n"));
    CHECK(strstr(text, "\n8,1.0000000000000e+00,1.0000000000000e+00,2.5000000000000e-01"));
    CHECK(strstr(text, "*BOUNDARY\n1,1,3\n2,1,3\n3,1,3\n4,1,3\n*MATERIAL"));
    CHECK(strstr(text, "SHEET,GRAV,9.8100000000000e+00,0,0,-1\n"));
    REQUIRE(!calculix_deck_hash(&job, hash[0]));
    job.poisson = 0.26;
    REQUIRE(!calculix_deck_hash(&job, hash[1]));
    CHECK(strlen(hash[0]) == 16 && strcmp(hash[0], hash[1]) != 0);

    job.element = CALCULIX_C3D20R;
    CHECK(calculix_deck_nodes(&job) == 20);
    /* Edges' middles, from the lattice by hand: rows of 3, 2, 3 at i = 0, of 2, 2 between.
     */
    text = deck(&job);
    CHECK(strstr(text, "\n1,1,13,18,6,3,15,20,8,9,16,\n11,4,10,17,12,5,2,14,19,7\n"));
    job.cells[0] = 3, job.cells[1] = 2, job.cells[2] = 2;
    CHECK(calculix_deck_nodes(&job) == 36 + 3 * 9 + 4 * 6 + 4 * 6);
    CHECK(calculix_deck_corner(&job, 0, 0, 2) == 4);

    job = one(CALCULIX_SWING);
    text = deck(&job);
    CHECK(strstr(text, "NLGEOM") && strstr(text, "ALPHA=0\n1.0000000000000e-02,2.000"));
    job = one(CALCULIX_MATRICES);
    text = deck(&job);
    CHECK(strstr(text, "SOLVER=MATRIXSTORAGE\n*END") && !strstr(text, "*BOUNDARY"));
}

/* ------------------------------------------------------------------ programs -------- */

/* A program of our own, in the folder of the deck; $job is its stem. */
static enum status run_fake(enum calculix_task task, const char *body, struct message *why)
{
    const struct calculix_job job = one(task);
    FILE *file = fopen(fake, "wb");
    REQUIRE(file != NULL);
    fprintf(file, "#!/bin/sh\njob=$2\n[ -f $job.inp ] || exit 9\n%s\n", body);
    REQUIRE(!fclose(file) && !chmod(fake, 0700));
    answer.times = -1;
    why->text[0] = 0;
    return calculix_run(&job, fake, &answer, why);
}

static void check_refused(enum calculix_task task, const char *body, const char *sentence)
{
    struct message why;
    CHECK(run_fake(task, body, &why) == STATUS_LIBRARY);
    CHECK(answer.times == -1); /* untouched */
    if (!CHECK(strstr(why.text, sentence)))
        printf("  said: %s\n  instead of: %s\n", why.text, sentence);
}

#define HEAD                                                                               \
    "head() { printf '\\n displacements (vx,vy,vz) for set ALL and time  %s\\n\\n' $1; "   \
    "}\n"
#define NODES                                                                              \
    "clamp() { for n in 1 2 3 4; do echo \"$n 0.0E+00 0.0E+00 0.0E+00\"; done; }\n"        \
    "tip() { for n in 5 6 7; do echo \"$n 1.0E-03 0.0E+00 $1\"; done; echo \"8 0 0 $1\"; " \
    "}\n"
#define TABLES HEAD NODES

static void check_shifts(void)
{
    const enum calculix_task still = CALCULIX_STATIC, swing = CALCULIX_SWING;
    struct message why;

    REQUIRE(!run_fake(still, TABLES "(head 1; clamp; tip -5E-2) >$job.dat", &why));
    CHECK(answer.times == 1 && isinf(answer.time[0]) && answer.points[0] == 2);
    CHECK(calculix_shift(&answer, 0, 1, 1)[2] == -0.05);
    CHECK(calculix_shift(&answer, 0, 1, 1)[0] == 0.0005); /* of nodes 7 and 8 */
    calculix_clear(&answer);
    REQUIRE(!run_fake(swing,
                      TABLES "(head 0.1E-01; clamp; tip -1E-2; head 0.2E-01; clamp; tip "
                             "-2E-2) >$job.dat",
                      &why));
    CHECK(answer.times == 2 && answer.time[1] == 0.02);
    CHECK(calculix_shift(&answer, 1, 1, 0)[2] == -0.02);
    calculix_clear(&answer);

    check_refused(still, "exit 0", "wrote no .dat file");
    check_refused(still, ">$job.dat", "no displacements at time 1");
    check_refused(still, TABLES "(head 2; clamp; tip -1) >$job.dat", "at time 1");
    check_refused(still, TABLES "(head 1; clamp) >$job.dat", "stops before node 5");
    check_refused(still, TABLES "(head 1; clamp; tip nan) >$job.dat", "node 5 by nan");
    check_refused(still, TABLES "(head 1; clamp; tip -9E9) >$job.dat", "no solution");
    check_refused(still, TABLES "(head 1; clamp; tip 1.0-101) >$job.dat", "before node 6");
    check_refused(still, TABLES "(head 1; clamp | sed s/0.0E/1.0E/; tip -1) >$job.dat",
                  "moves the clamped edge");
    check_refused(still, TABLES "(head 1; clamp; tip 0 | sed s/1.0E-03/0/) >$job.dat",
                  "does not move");
    check_refused(still, TABLES "(head 1; clamp; tip -1; head 1) >$job.dat", "more than 1");
    check_refused(swing, TABLES "(head 0.1E-01; clamp; tip -1) >$job.dat", "at time 0.02");
}

#define DOF                                                                                \
    "for n in 1 2 3 4 5 6 7 8; do for i in 1 2 3; do echo $n.$i; done; done >$job.dof\n"
#define DIAGONAL(file) "seq 24 | sed 's/.*/& & 2.5E-01/' >$job" file "\n"

static void check_matrices(void)
{
    const enum calculix_task task = CALCULIX_MATRICES;
    struct message why;

    /* Equations turned round; an entry above the diagonal. */
    REQUIRE(!run_fake(task,
                      DOF "sort -r $job.dof >$job.x; mv $job.x $job.dof\n" DIAGONAL(".mas")
                          DIAGONAL(".sti") "echo 1 24 3.0 >>$job.sti",
                      &why));
    CHECK(answer.K.rows == 24 && answer.K.entries == 25 && answer.M.entries == 24);
    CHECK(answer.K.row[0] == 23 && answer.K.column[0] == 23 && answer.K.value[0] == 0.25);
    CHECK(answer.K.row[24] == 23 && answer.K.column[24] == 0 && answer.K.value[24] == 3);
    calculix_clear(&answer);

    check_refused(task, "exit 0", "wrote no .dof file");
    check_refused(task, "echo 1.1 >$job.dof", "other than 24 unknowns");
    check_refused(task, "(echo 1.1; echo 1.1) >$job.dof", "equation 2 is of node 1");
    check_refused(task, "echo 9.1 >$job.dof", "equation 1 is of node 9");
    check_refused(task, DOF "echo 9.1 >>$job.dof", "other than 24 unknowns");
    check_refused(task, DOF, "wrote no .sti file");
    check_refused(task, DOF DIAGONAL(".sti"), "wrote no .mas file");
    check_refused(task, DOF "echo 1 1 nan >$job.sti", "entry 1 is 1 1 nan");
    check_refused(task, DOF "echo 1 25 1.0 >$job.sti", "entry 1 is 1 25 1");
    check_refused(task, DOF "seq 9 | sed 's/.*/& & 1.0/' >$job.sti", "stops after entry 9");
}

static void check_programs(void)
{
    const struct calculix_job job = one(CALCULIX_STATIC);
    const enum calculix_task still = CALCULIX_STATIC;
    struct message why = {""};

    check_refused(still, "echo first; echo the reason >&2; exit 201",
                  "exit code 201: the reason");
    check_refused(still,
                  "echo; echo ' *ERROR in e_c3d: nonpositive'; echo '   jacobian'\n"
                  "echo; echo more; exit 201",
                  "failed: *ERROR in e_c3d: nonpositive jacobian");
    CHECK(run_fake(still, "echo ' *ERROR in a: b'; echo; echo more", &why) ==
          STATUS_LIBRARY); /* exits 0 all the same */
    CHECK(!strcmp(strstr(why.text, " failed"), " failed: *ERROR in a: b"));
    check_refused(still, "kill -KILL $$", "signal 9: nothing was said");
    REQUIRE(!run_fake(still,
                      TABLES "echo 'CalculiX Version 9.87, Copyright'\n"
                             "(head 1; clamp; tip -5E-2) >$job.dat; >spooles.out",
                      &why));
    CHECK(!strcmp(answer.version, "9.87"));
    CHECK(access("spooles.out", F_OK)); /* rubbish stays in the temporary folder */
    calculix_clear(&answer);
    CHECK(calculix_run(&job, "no_such_ccx", &answer, &why) == STATUS_UNSUPPORTED);
    CHECK(strstr(why.text, "not installed (Debian: calculix-ccx)"));
}

/* ------------------------------------------------------------------ the real one ---- */

static void real(struct calculix_job job, const char *sentence)
{
    struct message why = {""};
    enum status st = calculix_run(&job, NULL, &answer, &why);

    if (st == STATUS_UNSUPPORTED) {
        printf("skipped: %s\n", why.text);
        exit(77);
    }
    printf("  %s\n", why.text);
    CHECK(st == STATUS_LIBRARY && strstr(why.text, sentence));
}

static void invert(double x[3])
{
    x[2] = -x[2];
}

static void real_failures(void)
{
    struct calculix_job job = one(CALCULIX_STATIC);

    job.place = invert;
    real(job, "nonpositive jacobian");
    job = one(CALCULIX_STATIC);
    job.poisson = 0.5;
    real(job, "*ERROR");
    job = one(CALCULIX_STATIC);
    job.density = 0;
    real(job, "does not move");
    job = one(CALCULIX_STATIC);
    job.young = 0;
    real(job, "Young modulus");
    job = one(CALCULIX_SWING); /* far too long a step */
    job.cells[0] = 20, job.thickness = 1e-4, job.step = job.end = 10;
    real(job, "*ERROR");
}

int main(int count, char **argument)
{
    if (count > 1 && !strcmp(argument[1], "failures")) {
        real_failures();
        return check_result();
    }
    scratch_open();
    fake = scratch_path("fake");
    check_decks();
    check_shifts();
    check_matrices();
    check_programs();
    CHECK(scratch_files(scratch) == 1);
    return check_result();
}
