#include "fem_ref/calculix_deck.h"

#include <stdint.h>
#include <stdlib.h>

const char *calculix_element_name(enum calculix_element element)
{
    static const char *const name[] = {"C3D8", "C3D8I", "C3D20R"};
    return name[element];
}

/* Returns the lattice points per cell side. Nodes lie on a lattice: the corners, for 20
 * nodes also the middles of edges; then the lattice is twice as fine and every point with
 * two odd indices is left out. */
static int fineness(const struct calculix_job *job)
{
    return job->element == CALCULIX_C3D20R ? 2 : 1;
}

static int node(const struct calculix_job *job, int i, int j, int k)
{
    int m = job->cells[1] + 1, l = job->cells[2] + 1;
    if (fineness(job) == 1)
        return (i * m + j) * l + k;

    int corners = 2 * l - 1; /* in a row with odd points; rows without have l */
    int even = m * corners + (m - 1) * l, odd = m * l; /* in a slice of equal i */
    int before = (i + 1) / 2 * even + i / 2 * odd;
    if (i % 2)
        return before + j / 2 * l + k / 2;
    return before + (j + 1) / 2 * corners + j / 2 * l + (j % 2 ? k / 2 : k);
}

static void write_nodes(const struct calculix_job *job, FILE *file)
{
    int f = fineness(job), *n = (int[3]){0};
    for (int i = 0; i < 3; i++)
        n[i] = f * job->cells[i];

    fprintf(file, "*NODE, NSET=ALL\n");
    for (int i = 0; i <= n[0]; i++)
        for (int j = 0; j <= n[1]; j++)
            for (int k = 0; k <= n[2]; k++) {
                if (f == 2 && i % 2 + j % 2 + k % 2 > 1)
                    continue;
                double x[3] = {job->length * i / n[0], job->width * j / n[1],
                               job->thickness * ((double)k / n[2] - 0.5)};
                if (job->place)
                    job->place(x);
                fprintf(file, "%d,%.13e,%.13e,%.13e\n", node(job, i, j, k) + 1, x[0], x[1],
                        x[2]);
            }
}

/* Writes elements (Manual 6.2.1, 6.2.5): bottom, top; middles of bottom, top, upright
 * edges. */
static void write_elements(const struct calculix_job *job, FILE *file)
{
    static const int corner[20][3] = {
        {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
        {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
        {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}};
    int f = fineness(job), *n = (int[3]){job->cells[0], job->cells[1], job->cells[2]};

    fprintf(file, "*ELEMENT, TYPE=%s, ELSET=SHEET\n", calculix_element_name(job->element));
    for (int e = 0; e < n[0] * n[1] * n[2]; e++) {
        int at[3] = {e / (n[1] * n[2]), e / n[2] % n[1], e % n[2]};
        fprintf(file, "%d", e + 1);
        for (int t = 0; t < (f == 2 ? 20 : 8); t++) {
            int p[3];
            for (int i = 0; i < 3; i++)
                p[i] = f * at[i] + f * corner[t][i] / 2;
            fprintf(file, t == 10 ? ",\n%d" : ",%d", node(job, p[0], p[1], p[2]) + 1);
        }
        fprintf(file, "\n");
    }
}

/* Holds the nodes with i = 0, which are the first; CalculiX refuses a node held twice. */
static void write_clamp(const struct calculix_job *job, FILE *file)
{
    fprintf(file, "*BOUNDARY\n");
    int f = fineness(job), last = node(job, 0, f * job->cells[1], f * job->cells[2]);
    for (int a = 0; a <= last; a++)
        fprintf(file, "%d,1,3\n", a + 1);
}

static void write_step(const struct calculix_job *job, FILE *file)
{
    if (job->task == CALCULIX_MATRICES) {
        fprintf(file, "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n*END STEP\n");
        return;
    }
    if (job->task == CALCULIX_STATIC)
        fprintf(file, "*STEP\n*STATIC\n");
    else
        fprintf(file,
                "*STEP, NLGEOM, INC=1000000, AMPLITUDE=STEP\n*DYNAMIC, DIRECT, ALPHA=0\n"
                "%.13e,%.13e\n",
                job->step, job->end);
    fprintf(file,
            "*DLOAD\nSHEET,GRAV,%.13e,0,0,-1\n*NODE PRINT, NSET=ALL, FREQUENCY=%d\nU\n"
            "*END STEP\n",
            job->gravity, job->task == CALCULIX_SWING ? job->every : 1);
}

void calculix_deck_write(const struct calculix_job *job, FILE *file)
{
    write_nodes(job, file);
    write_elements(job, file);
    if (job->task != CALCULIX_MATRICES)
        write_clamp(job, file);
    fprintf(file,
            "*MATERIAL, NAME=CLOTH\n*ELASTIC\n%.13e,%.13e\n*DENSITY\n%.13e\n"
            "*SOLID SECTION, ELSET=SHEET, MATERIAL=CLOTH\n",
            job->young, job->poisson, job->density);
    write_step(job, file);
}

enum status calculix_deck_hash(const struct calculix_job *job, char hash[17])
{
    char *text = NULL;
    size_t size = 0;
    uint64_t h = 14695981039346656037u;
    FILE *file = open_memstream(&text, &size);

    if (!file)
        return STATUS_MEMORY;
    calculix_deck_write(job, file);
    if (fclose(file)) {
        free(text);
        return STATUS_MEMORY;
    }
    for (size_t i = 0; i < size; i++)
        h = (h ^ (unsigned char)text[i]) * 1099511628211u;
    snprintf(hash, 17, "%016llx", (unsigned long long)h);
    free(text);
    return STATUS_OK;
}
