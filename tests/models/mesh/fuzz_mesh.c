/* Flat patterns from any OBJ file, for libFuzzer or from files (fuzz.h). Beyond crashes,
 * leaks and undefined behaviour it stops at: a refusal without a printable sentence that
 * names the file; a mesh that is not the whole sheet, or whose triangles, bent either way,
 * are not at rest at rest and have no finite energy where they are stretched. */
#define _GNU_SOURCE /* memfd_create */
#include <math.h>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/fuzz.h"
#include "triangles/tri_shell.h"

/* The sheet's energy at rest over that when stretched to twice its length: round-off. */
static const double ROUNDING = 1e-12;
/* The reader's allowance for numbers of a file. */
static const double NEAR = 1e-4;

static void check_sheet(const struct scene *scene, const struct mesh *mesh,
                        enum bending bending)
{
    struct tri_shell shell;
    double *x = malloc(3 * (size_t)mesh->nodes * sizeof *x), area = 0;

    MUST(x);
    for (int a = 0; a < mesh->vertices; a++)
        area += mesh->area[a];
    MUST(fabs(area - scene->length * scene->width) <= NEAR);
    MUST(tri_shell_init(&shell, scene, mesh, MEMBRANE_GREEN, bending, false) == STATUS_OK);
    for (int n = 0; n < 3 * mesh->nodes; n++)
        x[n] = (n < 3 * mesh->vertices && n % 3 == 0 ? 2 : 1) * mesh->rest[n];
    const double stretched = tri_shell_energy(&shell, x);
    MUST(isfinite(stretched) && stretched > 0);
    MUST(fabs(tri_shell_energy(&shell, mesh->rest)) <= ROUNDING * stretched);
    tri_shell_clear(&shell);
    free(x);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct {
        enum bending bending;
        enum mesh_edges edges;
    } kinds[] = {{BENDING_MIDEDGE, MESH_TURNS}, {BENDING_QUADRATIC, MESH_SLOPES}};
    char path[64];
    struct scene scene;
    const int file = memfd_create("mesh", 0);

    MUST(file >= 0 && write(file, data, size) == (ssize_t)size);
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    MUST(scene_init(&scene) == STATUS_OK);
    scene.thickness = 1e-3, scene.young = 1e5, scene.density = 1;
    for (int k = 0; k < 2; k++) {
        struct discretization d = {.points = {2, 2, 1}, .mesh = path};
        struct message why = {""};
        struct mesh mesh = {0};
        const enum status st = mesh_make(&mesh, &scene, &d, kinds[k].edges, &why);
        MUST(st == STATUS_OK || st == STATUS_INPUT);
        if (st == STATUS_OK)
            check_sheet(&scene, &mesh, kinds[k].bending);
        else
            fuzz_check_sentence(&why, path);
        mesh_clear(&mesh);
    }
    scene_clear(&scene);
    close(file);
    return 0;
}
