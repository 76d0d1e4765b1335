/* Readers of other people's frames: the samples come back in each format (tests/samples,
 * see its README). (What is refused: commands/score_frames.cases.) */
#include "bench/frames/frames.h"

#include "tests/check.h"

#define SAMPLES SOURCE_DIR "/tests/samples/"

/* A net of N_U x N_V vertices, TIMES of it, whose numbers are exact in 32 bits. */
enum { N_U = 5, N_V = 4, VERTICES = N_U * N_V, TIMES = 3 };

static void sample(int k, int n, double xyz[3])
{
    const double u = n % N_U / (N_U - 1.), v = n / N_U / 4.;

    xyz[0] = u - k / 64., xyz[1] = v, xyz[2] = -k * k * (1 + u) / 128.;
}

/* Reads all frames; *same: how many are the sample's, at their times. Vertices are told by
 * their uv, so that their order is the file's; without uv it is ours. */
static enum status read_all(const char *path, double dt, const char *rest, bool has_uv,
                            int *same, struct message *why)
{
    struct frames *f = NULL;
    const double *xyz = NULL;
    double t;
    enum status st = frames_open(1, &path, &(struct frames_look){dt, rest}, &f, why);

    *same = 0;
    for (int k = 0; st == STATUS_OK; k++) {
        const struct frames_net *net = frames_net(f);
        st = frames_next(f, &t, &xyz, why);
        if (st != STATUS_OK || !xyz)
            break;
        bool good = (net->uv != NULL) == has_uv && net->vertices == VERTICES &&
                    t == k * (dt > 0 ? dt : 1 / 16.);
        for (int n = 0; n < VERTICES && good; n++) {
            const double *uv = net->uv + 2 * n;
            double want[3];
            sample(k, has_uv ? (int)(4 * uv[0] + N_U * 4 * uv[1] + .5) : n, want);
            good = !memcmp(want, xyz + 3 * n, sizeof want);
        }
        *same = good && *same == k ? k + 1 : -1;
    }
    frames_close(f);
    return st;
}

/* Returns how many triangles a file's net has, if the first two are those of the cell 0. */
static int triangles_of(const char *path)
{
    static const int first[2][3] = {{0, 1, 6}, {0, 6, 5}};
    struct frames *f = NULL;
    int count = 0;

    if (frames_open(1, &path, &(struct frames_look){0}, &f, NULL) == STATUS_OK &&
        !memcmp(frames_net(f)->triangle, first, sizeof first))
        count = frames_net(f)->triangles;
    frames_close(f);
    return count;
}

static void come_back(void)
{
    static const struct {
        const char *path, *rest;
        double dt;
        bool without_uv;
        int triangles; /* of the file, beside those of a mesh */
    } row[] = {{SAMPLES "plain.csv"},
               {SAMPLES "spaced.csv"},
               {SAMPLES "columns.csv"},
               {SAMPLES "objs", .dt = 0.25},
               {SAMPLES "ply", .dt = 0.5},
               {SAMPLES "stored.npz"},
               {SAMPLES "packed.npz"},
               {SAMPLES "packed.npz", .dt = 0.125},
               {SAMPLES "bare.npy", .dt = 0.5, .without_uv = true},
               {SAMPLES "bare.npy", SAMPLES "objs/s9.obj", .dt = 0.5},
               {SAMPLES "c.mdd", SAMPLES "objs/s9.obj"},
               {SAMPLES "c.pc2", SAMPLES "objs/s9.obj", .dt = 0.125},
               {SAMPLES "c.h5"},
               {SAMPLES "faces.npz", .triangles = 24},
               {SAMPLES "faces.h5", .triangles = 24},
               {SAMPLES "semicolons.csv"},
               {SAMPLES "rate.pc2", SAMPLES "objs/s9.obj"},
               {SAMPLES "rate.pc2", SAMPLES "objs/s9.obj", .dt = 0.125}};

    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        struct message why = {""};
        int same;
        CHECK_SAY(read_all(row[n].path, row[n].dt, row[n].rest, !row[n].without_uv, &same,
                           &why) == STATUS_OK &&
                      same == TIMES &&
                      (!row[n].triangles || triangles_of(row[n].path) == row[n].triangles),
                  "%s: %d frames, %s", row[n].path, same, why.text);
    }
}

int main(void)
{
    come_back();
    return check_result();
}
