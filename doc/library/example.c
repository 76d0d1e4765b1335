/* A sheet's free corner, frame by frame: ./example SCENE.yaml CONTESTANT */
#include <stdio.h>

#include "bench/harness/run.h"
#include "models/status.h"

int main(int argc, char **argv)
{
    static const double corner[3] = {1, 1, 0.5}; /* u, v, w */
    const struct contestant *who;
    struct message why = {""};
    struct run run = {0};
    struct counters work = {0};
    enum status st = STATUS_INPUT;

    if (argc != 3 || contestant_find(argv[2], &who, &why))
        goto out;
    st = run_open(&run, &(struct case_plan){.path = argv[1], .contestant = who}, &why);
    for (double t = 0; !st && t < run.scene.end - run.scene.step / 2;) {
        double x[3];
        t += run.scene.step;
        st = run.model->advance(run.state, &work);
        run.model->probe(run.state, 1, corner, x);
        printf("%.6g %.17g %.17g %.17g\n", t, x[0], x[1], x[2]);
    }
out:
    if (st)
        fprintf(stderr, "%s\n", *why.text ? why.text : status_text(st));
    run_close(&run);
    return st != STATUS_OK;
}
