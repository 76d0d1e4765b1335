#include "bench/files/provenance.h"

#include <assert.h>
#include <cholmod.h>
#include <omp.h>
#include <provenance_commit.h> /* made by cmake/provenance.cmake at every build */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>
#include <time.h>
#include <unistd.h>

#include "bench/files/hdf5_file.h"
#include "models/linalg/blas_kernel.h"

__attribute__((format(printf, 3, 4))) static void add(struct provenance *p, const char *key,
                                                      const char *format, ...)
{
    assert(p->count < PROVENANCE_MAX);
    struct provenance_entry *entry = &p->entry[p->count++];
    va_list args;

    entry->key = key;
    va_start(args, format);
    vsnprintf(entry->value, sizeof entry->value, format, args);
    va_end(args);
}

/* Reads what stands behind `key`, blanks and `separator` in the first line of a system file
 * that begins with key; quotes around it are dropped. */
static void read_line(const char *path, const char *key, char separator, char *text,
                      size_t size)
{
    char line[512];
    FILE *file = fopen(path, "r");

    snprintf(text, size, "unknown");
    while (file && fgets(line, sizeof line, file)) {
        char *value = strchr(line, separator);
        if (!value || strncmp(line, key, strlen(key)) != 0)
            continue;
        value += 1 + strspn(value + 1, " \"");
        value[strcspn(value, "\"\n")] = '\0';
        snprintf(text, size, "%s", value);
        break;
    }
    if (file)
        fclose(file);
}

static void add_build(struct provenance *p)
{
    add(p, "program", "clothbench " PROVENANCE_VERSION);
    add(p, "commit", "%s", PROVENANCE_COMMIT);
    add(p, "changed_files", "%s", PROVENANCE_CHANGED);
    add(p, "solvers", "%s", PROVENANCE_SOLVERS);
    add(p, "compiler", "%s", PROVENANCE_COMPILER);
    add(p, "build_type", "%s", PROVENANCE_BUILD_TYPE);
    add(p, "flags", "%s", PROVENANCE_FLAGS);
}

static void add_libraries(struct provenance *p)
{
    int cholmod[3];
    unsigned major, minor, release;

    cholmod_version(cholmod);
    add(p, "cholmod", "%d.%d.%d", cholmod[0], cholmod[1], cholmod[2]);
    hdf5_file_start();
    H5get_libversion(&major, &minor, &release);
    add(p, "hdf5", "%u.%u.%u", major, minor, release);
    add(p, "blas", "%s", blas_kernel_version());
    add(p, "blas_kernel", "%s", blas_kernel_name());
}

static void add_machine(struct provenance *p)
{
    char cpu[256], distribution[128];
    struct utsname system;

    read_line("/proc/cpuinfo", "model name", ':', cpu, sizeof cpu);
    read_line("/etc/os-release", "PRETTY_NAME", '=', distribution, sizeof distribution);
    add(p, "cpu", "%s", cpu);
    add(p, "cores", "%ld", sysconf(_SC_NPROCESSORS_ONLN));
    add(p, "cores_usable", "%d", omp_get_num_procs());
    add(p, "memory_bytes", "%lld",
        (long long)sysconf(_SC_PHYS_PAGES) * sysconf(_SC_PAGESIZE));
    if (uname(&system) == 0)
        add(p, "system", "%s, %s %s %s", distribution, system.sysname, system.release,
            system.machine);
    else
        add(p, "system", "%s", distribution);
}

void provenance_collect(struct provenance *p)
{
    char date[32] = "unknown";
    time_t now = time(NULL);
    struct tm utc;

    p->count = 0;
    add_build(p);
    add_libraries(p);
    add_machine(p);
    add(p, "omp_threads", "%d", omp_get_max_threads());
    add(p, "blas_threads", "%d", blas_kernel_threads());
    if (gmtime_r(&now, &utc))
        strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
    add(p, "date", "%s", date);
}

const char *provenance_value(const struct provenance *p, const char *key)
{
    for (int i = 0; i < p->count; i++)
        if (!strcmp(p->entry[i].key, key))
            return p->entry[i].value;
    return NULL;
}
