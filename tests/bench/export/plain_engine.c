/* A plain engine of somebody else's: springs, angles between triangles, masses at vertices
 * and explicit steps, made of nothing but the files that `clothbench export` leaves and
 * what their README.md says. plain_engine FOLDER COLUMNS STEP DAMPING GX GY GZ TIME...
 * >frames.csv COLUMNS vertices along u, or 0 of triangles in any order, whose hinges are
 * listed; DAMPING of mass [1/s]. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NEED(x) ((x) ? (void)0 : (fprintf(stderr, "plain_engine: no %s\n", #x), exit(1)))

enum { MOST = 20000 };
static int sheet, vertices, columns; /* those of the sheet, and with those outside     */
static double uv[MOST][2], x[MOST][3], v[MOST][3], force[MOST][3], mass[MOST];
static bool held[MOST];
static int beside[MOST];

static int triangles, triangle[2 * MOST][3];
static int springs;
static struct spring {
    int a, b;
    double stiffness, length;
} spring[5 * MOST];
static int hinges;
static struct hinge {
    int edge[2], wing[2];
    double stiffness;
} hinge[4 * MOST];
/* of edges along u, v and diagonals; then the same at a clamp, where diagonals have none */
static double stiffness[2][3];

static FILE *open_file(const char *folder, const char *name)
{
    char path[4096];

    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "r");
    NEED(file);
    return file;
}

static void read_vertices(const char *folder)
{
    char line[512];
    FILE *file = open_file(folder, "rest.csv");

    NEED(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        NEED(sheet < MOST &&
             sscanf(line, "%*d,%lf,%lf,%lf,%lf,%lf", &uv[sheet][0], &uv[sheet][1],
                    &x[sheet][0], &x[sheet][1], &x[sheet][2]) == 5);
        sheet++;
    }
    fclose(file);
    vertices = sheet;
}

static void read_held(const char *folder)
{
    char line[512];
    FILE *file = open_file(folder, "held.csv");

    NEED(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        int n;
        double place[5];
        NEED(sscanf(line, "%d,%lf,%lf,%lf,%lf,%lf", &n, &place[0], &place[1], &place[2],
                    &place[3], &place[4]) == 6);
        NEED(n >= 0 && n < MOST);
        held[n] = true;
        memcpy(uv[n], place, sizeof uv[n]);
        memcpy(x[n], place + 2, sizeof x[n]);
        beside[n] = atoi(strrchr(line, ',') + 1);
        vertices = n >= vertices ? n + 1 : vertices;
    }
    fclose(file);
}

static void read_materials(const char *folder)
{
    static const char *const name[2][3] = {{"hinge u", "hinge v", "hinge diagonal"},
                                           {"hinge u held", "hinge v held", "none"}};
    char line[512], word[64], unit[32];
    FILE *file = open_file(folder, "materials.csv");

    while (fgets(line, sizeof line, file)) {
        struct spring s;
        double value;
        int a;
        if (sscanf(line, "mass,%d,,%lf", &a, &value) == 2)
            mass[a] = value;
        else if (sscanf(line, "spring,%d,%d,%lf,%31[^,],%lf", &s.a, &s.b, &s.stiffness,
                        unit, &s.length) == 5)
            spring[springs++] = s;
        else if (sscanf(line, "spring %63[a-z],%d,%d,%lf,%31[^,],%lf", word, &s.a, &s.b,
                        &s.stiffness, unit, &s.length) == 6)
            spring[springs++] = s;
        else if (sscanf(line, "%63[^,],,,%lf", word, &value) == 2)
            for (int n = 0; n < 6; n++)
                if (!strcmp(word, name[n / 3][n % 3]))
                    stiffness[n / 3][n % 3] = value;
    }
    fclose(file);
}

static void add_triangle(int a, int b, int c)
{
    memcpy(triangle[triangles++], (int[]){a, b, c}, sizeof *triangle);
}

static void read_triangles(const char *folder)
{
    char line[512];
    FILE *file = open_file(folder, "rest.obj");

    while (fgets(line, sizeof line, file)) {
        int a, b, c;
        if (sscanf(line, "f %d%*s %d%*s %d", &a, &b, &c) == 3)
            add_triangle(a - 1, b - 1, c - 1);
    }
    fclose(file);
    NEED(triangles);
}

/* Returns whether diagonals meet at a vertex: they join those of one colour, of which the
 * first inside the sheet has eight neighbours, or else four. */
static bool has_diagonals(int n)
{
    const int first = columns + 1;
    int neighbours = 0;

    for (int t = 0; t < triangles; t++)
        for (int i = 0; i < 3; i++)
            neighbours += triangle[t][i] == first;
    const bool same = (n % columns + n / columns) % 2 == 0; /* as first, at 1, 1 */
    return (neighbours == 8) == same;
}

/* Cells between a held row and the vertices outside. */
static void add_outside(void)
{
    for (int p = sheet; p < vertices; p++)
        for (int q = p + 1; q < vertices; q++) {
            const int a = beside[p], b = beside[q];
            const int i = abs(a % columns - b % columns),
                      j = abs(a / columns - b / columns);
            if (i + j != 1)
                continue;
            add_triangle(a, b, has_diagonals(a) ? q : p);
            add_triangle(p, q, has_diagonals(a) ? a : b);
        }
}

static void add_hinge(int a, int b, int c, int d)
{
    const bool u = fabs(uv[a][0] - uv[b][0]) > 1e-9, w = fabs(uv[a][1] - uv[b][1]) > 1e-9;
    const bool edge = held[a] && held[b];

    if (edge && held[c] && held[d])
        return;
    hinge[hinges++] = (struct hinge){{a, b},
                                     {c, d},
                                     stiffness[edge && (held[c] || held[d])][u && w ? 2
                                                                             : u    ? 0
                                                                                    : 1]};
}

static void read_hinges(const char *folder)
{
    char line[512];
    FILE *file = open_file(folder, "hinges.csv");

    NEED(fgets(line, sizeof line, file));
    while (fgets(line, sizeof line, file)) {
        struct hinge *h = &hinge[hinges++];
        NEED(sscanf(line, "%d,%d,%d,%d,%lf", &h->edge[0], &h->edge[1], &h->wing[0],
                    &h->wing[1], &h->stiffness) == 5);
    }
    fclose(file);
}

/* Joins every two triangles that have an edge in common. */
static void find_hinges(void)
{
    static int first[MOST][10], wing[MOST][10], count[MOST]; /* edges from a vertex    */

    for (int t = 0; t < triangles; t++)
        for (int i = 0; i < 3; i++) {
            const int a = triangle[t][i], b = triangle[t][(i + 1) % 3];
            const int low = a < b ? a : b, high = a < b ? b : a,
                      c = triangle[t][(i + 2) % 3];
            int k = 0;
            while (k < count[low] && first[low][k] != high)
                k++;
            if (k < count[low]) {
                add_hinge(low, high, wing[low][k], c);
                continue;
            }
            NEED(k < 10);
            first[low][k] = high, wing[low][k] = c, count[low]++;
        }
}

static double dot(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double *a, const double *b, double *c)
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Each wing turns about the edge: its force is k theta over its distance from it, along its
 * normal, and the edge takes what keeps forces and moments in balance. */
static void bend(const struct hinge *h)
{
    const int a = h->edge[0], b = h->edge[1];
    double e[3], arm[2][3], normal[2][3], both[3];

    for (int i = 0; i < 3; i++) {
        e[i] = x[b][i] - x[a][i];
        for (int n = 0; n < 2; n++)
            arm[n][i] = x[h->wing[n]][i] - x[a][i];
    }
    cross(e, arm[0], normal[0]);
    cross(arm[1], e, normal[1]);
    cross(normal[0], normal[1], both);
    const double length = sqrt(dot(e, e));
    const double angle = atan2(dot(both, e) / length, dot(normal[0], normal[1]));
    for (int n = 0; n < 2; n++) {
        const double pull = h->stiffness * angle * length / dot(normal[n], normal[n]);
        const double share = dot(arm[n], e) / (length * length);
        for (int i = 0; i < 3; i++) {
            const double f = pull * normal[n][i];
            force[h->wing[n]][i] += f;
            force[a][i] -= (1 - share) * f;
            force[b][i] -= share * f;
        }
    }
}

static void stretch(const struct spring *s)
{
    double d[3];

    for (int i = 0; i < 3; i++)
        d[i] = x[s->b][i] - x[s->a][i];
    const double length = sqrt(dot(d, d));
    for (int i = 0; i < 3; i++) {
        const double f = s->stiffness * (length - s->length) / length * d[i];
        force[s->a][i] += f;
        force[s->b][i] -= f;
    }
}

static void step(double dt, double damping, const double gravity[3])
{
    memset(force, 0, sizeof force);
    for (int n = 0; n < springs; n++)
        stretch(&spring[n]);
    for (int n = 0; n < hinges; n++)
        bend(&hinge[n]);
    for (int n = 0; n < sheet; n++)
        for (int i = 0; i < 3 && !held[n]; i++) {
            v[n][i] += dt * (force[n][i] / mass[n] + gravity[i]);
            v[n][i] /= 1 + damping * dt;
            x[n][i] += dt * v[n][i];
        }
}

int main(int argc, char **argv)
{
    NEED(argc > 8);
    const double dt = atof(argv[3]), damping = atof(argv[4]);
    const double gravity[3] = {atof(argv[5]), atof(argv[6]), atof(argv[7])};
    long done = 0;

    columns = atoi(argv[2]);
    read_vertices(argv[1]);
    read_held(argv[1]);
    read_materials(argv[1]);
    read_triangles(argv[1]);
    if (columns == 0) {
        read_hinges(argv[1]);
    } else {
        add_outside();
        find_hinges();
    }
    puts("t,u,v,x,y,z");
    for (int t = 8; t < argc; t++) {
        for (; (double)done * dt < atof(argv[t]) - dt / 2; done++)
            step(dt, damping, gravity);
        for (int n = 0; n < sheet; n++)
            printf("%s,%.12g,%.12g,%.12g,%.12g,%.12g\n", argv[t], uv[n][0], uv[n][1],
                   x[n][0], x[n][1], x[n][2]);
    }
    return ferror(stdout) || fflush(stdout);
}
