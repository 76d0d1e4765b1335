/* The origin of a number: every entry is there, those of libraries and threads are what
 * they say themselves, and collecting again leaves no file open. */
#include "bench/files/provenance.h"

#include <cholmod.h>
#include <omp.h>
#include <provenance_commit.h> /* as bench/files/provenance.c has it */

#include "bench/files/hdf5_file.h"
#include "models/linalg/blas_kernel.h"
#include "tests/scratch.h"

enum { THREADS = 3 }; /* another number than BLAS has */

int main(void)
{
    static const char *const keys[] = {
        "program", "compiler", "build_type",    "flags",        "cpu",
        "cores",   "system",   "changed_files", "memory_bytes", "cores_usable"};
    struct provenance p;
    char cholmod[32], hdf5[32];

    omp_set_num_threads(THREADS);
    blas_kernel_set_threads(1);
    provenance_collect(&p);
    snprintf(cholmod, sizeof cholmod, "%d.%d.%d", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION,
             CHOLMOD_SUBSUB_VERSION);
    snprintf(hdf5, sizeof hdf5, "%d.%d.%d", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
    const struct {
        const char *key, *value;
    } want[] = {{"omp_threads", "3"},
                {"blas_threads", "1"},
                {"commit", PROVENANCE_COMMIT},
                {"solvers", PROVENANCE_SOLVERS},
                {"cholmod", cholmod},
                {"hdf5", hdf5},
                {"blas", blas_kernel_version()},
                {"blas_kernel", blas_kernel_name()}};
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        const char *value = provenance_value(&p, want[n].key);
        CHECK_SAY(value && !strcmp(value, want[n].value), "%s: %s", want[n].key,
                  value ? value : "none");
    }
    for (size_t n = 0; n < sizeof keys / sizeof *keys; n++) {
        const char *value = provenance_value(&p, keys[n]);
        CHECK(value && *value && !strchr(value, '\n'));
    }
    CHECK(strlen(provenance_value(&p, "date")) == strlen("2026-01-01T00:00:00Z"));
    CHECK(!provenance_value(&p, "none"));
    const int open = scratch_files("/proc/self/fd"), count = p.count;
    provenance_collect(&p); /* anew, not in addition */
    CHECK(p.count == count && scratch_files("/proc/self/fd") == open);
    return check_result();
}
