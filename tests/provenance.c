/* Where a number comes from: each entry against another source of the same. */
#include "bench/files/provenance.h"

#include <cholmod.h>
#include <omp.h>
#include <provenance_commit.h> /* as bench/files/provenance.c has it */
#include <stdarg.h>
#include <sys/sysinfo.h>
#include <sys/utsname.h>
#include <unistd.h>

#include "bench/files/hdf5_file.h"
#include "models/linalg/blas_kernel.h"
#include "tests/scratch.h"

enum { THREADS = 3 };

/* What the system says behind `key` and `separator` in its file; "" if nothing. */
static const char *system_line(const char *path, const char *key, char separator)
{
    static char line[512];
    FILE *file = fopen(path, "r");
    char *value = NULL;

    while (file && !value && fgets(line, sizeof line, file))
        if (!strncmp(line, key, strlen(key)))
            value = strchr(line, separator) + 1;
    if (file)
        fclose(file);
    if (!value)
        return "";
    value += strspn(value, " \"");
    value[strcspn(value, "\"\n")] = '\0';
    return value;
}

static void check_value(const struct provenance *p, const char *key, const char *format,
                        ...)
{
    char want[PROVENANCE_TEXT];
    const char *value = provenance_value(p, key);
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(want, sizeof want, format, arguments);
    va_end(arguments);
    printf("  %s: %s\n", key, value ? value : "(none)");
    if (!CHECK(value && !strcmp(value, want)))
        printf("  wanted: %s\n", want);
}

/* Each from another source than the one that the program asks, where there is one; it was
 * told of THREADS threads, which is another number than BLAS has. */
static void check_all(const struct provenance *p)
{
    struct utsname here;
    int year = 0, month = 0, day = 0;

    REQUIRE(uname(&here) == 0);
    check_value(p, "omp_threads", "%d", THREADS);
    check_value(p, "blas_threads", "1");
    check_value(p, "commit", "%s", PROVENANCE_COMMIT);
    check_value(p, "changed_files", "%s", PROVENANCE_CHANGED);
    check_value(p, "solvers", "%s", PROVENANCE_SOLVERS);
    check_value(p, "cholmod", "%d.%d.%d", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION,
                CHOLMOD_SUBSUB_VERSION);
    check_value(p, "hdf5", "%d.%d.%d", H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
    check_value(p, "cores", "%d", get_nprocs());
    check_value(p, "cores_usable", "%d", omp_get_num_procs());
    check_value(p, "memory_bytes", "%lld",
                (long long)get_phys_pages() * sysconf(_SC_PAGESIZE));
    check_value(p, "system", "%s, %s %s %s",
                system_line("/etc/os-release", "PRETTY_NAME", '='), here.sysname,
                here.release, here.machine);
    const char *cpu = system_line("/proc/cpuinfo", "model name", ':');
    check_value(p, "cpu", "%s", *cpu ? cpu : "unknown");
    check_value(p, "blas", "%s", blas_kernel_version());
    check_value(p, "blas_kernel", "%s", blas_kernel_name());
    static const struct {
        const char *key, *part;
    } rest[] = {{"program", "clothbench 0."},
                {"compiler", "."},
                {"build_type", "e"},
                {"flags", "-ffp-contract=off"},
                {"date", "Z"}};
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++) {
        const char *value = provenance_value(p, rest[i].key);
        CHECK(value && strstr(value, rest[i].part) && !strchr(value, '\n'));
    }
    CHECK(p->count == 14 + 5);
    CHECK(sscanf(provenance_value(p, "date"), "%4d-%2d-%2dT", &year, &month, &day) == 3);
    CHECK(year >= 2024 && month >= 1 && month <= 12 && day >= 1 && day <= 31);
    CHECK(!provenance_value(p, "none"));
    const char *commit = provenance_value(p, "commit");
    CHECK(!strcmp(commit, "unknown") || strspn(commit, "0123456789abcdef") >= 40);
}

int main(void)
{
    struct provenance p;

    omp_set_num_threads(THREADS);
    blas_kernel_set_threads(1);
    provenance_collect(&p);
    check_all(&p);
    const int open = scratch_files("/proc/self/fd");
    provenance_collect(&p); /* anew, not in addition */
    CHECK(p.count == 14 + 5 && scratch_files("/proc/self/fd") == open);
    return check_result();
}
