#define _GNU_SOURCE /* environ */
/* main.c - finds the command, prints what went wrong and exits; nobody else does. */
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/atomic_file.h"
#include "bench/commands.h"
#include "bench/files/output.h"
#include "bench/experiment/plan.h"
#include "bench/files/provenance.h"
#include "bench/harness/contestant.h"
#include "bench/harness/measures.h"
#include "bench/data/printer.h"
#include "models/linalg/blas_kernel.h"
#include "models/reader/scene_schema.h"

/* Exit codes; EXIT_USAGE stands for bad input, too. */
enum { EXIT_DONE = 0, EXIT_DIED = 1, EXIT_USAGE = 2 };

static int exit_code(enum status st)
{
    switch (st) {
    case STATUS_OK:
        return EXIT_DONE;
    case STATUS_INPUT:
    case STATUS_UNSUPPORTED:
        return EXIT_USAGE;
    default:
        return EXIT_DIED;
    }
}

static void print_help(FILE *file)
{
    fputs("usage: clothbench COMMAND [ARGUMENT]...\n\n"
          "Runs cloth models on the same scenes and compares their speed and error.\n\n"
          "Commands:\n",
          file);
    for (int n = 0; commands[n]; n++)
        fprintf(file, "  %-8s%s\n", commands[n]->name, commands[n]->summary);
    fputs("  help    print this text, or the options and examples of a command: help "
          "COMMAND\n"
          "  version print commit, compiler, libraries, machine and threads\n"
          "\nExamples:\n"
          "  clothbench list scenes\n"
          "  clothbench run edge_drop\n"
          "  clothbench run cantilever --static\n"
          "  clothbench help run\n"
          "\nExit code: 0 done; 1 a run died or a check failed; 2 bad input or usage.\n",
          file);
}

static void print_key(void *file, const char *key, const char *text)
{
    char name[64];

    snprintf(name, sizeof name, "  %s", key);
    wrap_item(name, 30, text, file);
}

static void print_scene_help(FILE *file)
{
    const struct model *model;

    fputs(
        "A scene is a YAML file of physics, in SI units; clothbench list scenes names "
        "those\n"
        "that come with the program. Its keys, and those of the discretization, which the\n"
        "command line alone gives:\n\n",
        file);
    scene_schema_list(print_key, file);
    for (int n = 0; (model = contestant_model(n)); n++)
        schema_list(model->options, "discretization.", print_key, file);
    fputs(
        "\n--set KEY=VALUE overrides any of them; the value is YAML, later settings win:\n"
        "  --set material.young=5e4 --set 'damping={kind: none}' --set "
        "supports[0].fix=xy\n",
        file);
}

static void print_plan_help(FILE *file)
{
    fputs("A plan is a YAML file; clothbench list plans names those that come with the\n"
          "program. Without times it is for clothbench sweep, with times for clothbench\n"
          "study. Its keys:\n\n",
          file);
    plan_keys(print_key, file);
    fputs(
        "\nAxes are KEY: [VALUE, ...], KEY: {from: ..., to: ..., count: ...} or AXIS: "
        "{LABEL:\n"
        "{KEY: VALUE, ...}, ...}, and every combination of them is a case.\n"
        "KEY is any that --set takes (clothbench help scene), scene, model, or gamma or\n"
        "young_over_density, which set material.young so that the number takes the value.\n"
        "Measures of verdicts:\n\n",
        file);
    for (int n = 0; n < MEASURES; n++)
        fprintf(file, "  %-20s%-9s%s\n", measure_name(n), measure_unit(n),
                measure_sentence(n));
}

static enum status print_version(void)
{
    static struct provenance p;

    provenance_collect(&p);
    for (int n = 0; n < p.count; n++)
        wrap_item(p.entry[n].key, 16, p.entry[n].value, stdout);
    return STATUS_OK;
}

static bool asks_for_help(int argc, char **argv)
{
    for (int n = 0; n < argc && strcmp(argv[n], "--"); n++)
        if (!strcmp(argv[n], "--help") || !strcmp(argv[n], "-h"))
            return true;
    return false;
}

/* Returns whether the overview explains the word, being no command of the table. */
static bool is_word_of_main(const char *word)
{
    return !strcmp(word, "help") || !strcmp(word, "version");
}

/* Runs the program's words after its name. */
static enum status run(int argc, char **argv, struct message *why)
{
    enum status st = STATUS_OK;
    const struct command *command = NULL;
    struct command_line line SCOPED(command_line_clear) = {0};
    bool help;

    if (!argc)
        return status_fail(why, STATUS_INPUT, "which command? clothbench help lists them");
    if (!strcmp(argv[0], "version") || !strcmp(argv[0], "--version"))
        return print_version();
    help = !strcmp(argv[0], "help");
    if ((help && (argc == 1 || is_word_of_main(argv[1]))) || asks_for_help(1, argv)) {
        print_help(stdout);
        return STATUS_OK;
    }
    if (help && !strcmp(argv[1], "scene")) {
        print_scene_help(stdout);
        return STATUS_OK;
    }
    if (help && !strcmp(argv[1], "plan")) {
        print_plan_help(stdout);
        return STATUS_OK;
    }
    CALL(commands_find(argv[help], &command, why));
    if (help || asks_for_help(argc - 1, argv + 1)) {
        command_help(command, stdout);
        return STATUS_OK;
    }
    CALL(command_parse(command, argc - 1, argv + 1, &line, why));
    st = command->run(&line, why);
    const enum status printed = printer_close(&line.printer);
    st = st == STATUS_OK ? printed : st;
    return st;
}

/* The most threads: more overrun the stacks of the libraries that start them. */
enum { THREADS_MOST = 1024 };

/* Returns whether OMP_NUM_THREADS, if it is set, is a number, or one a level (4,2): what
 * the library cannot read it takes for all processors. */
static bool threads_are_few(struct message *why)
{
    const char *text = getenv("OMP_NUM_THREADS"), *at = text;
    char *end;

    while (at && *at) {
        const long count = strtol(at, &end, 10);
        if (end == at || count < 1 || count > THREADS_MOST || (*end && *end != ',')) {
            status_fail(why, STATUS_INPUT,
                        "OMP_NUM_THREADS=%.32s: a number from 1 to %d "
                        "would be right",
                        text, THREADS_MOST);
            return false;
        }
        at = end + (*end == ',');
    }
    return true;
}

/* Returns the OpenBLAS kernel for this CPU; NULL: the library's own choice is as good. */
static char *kernel_for_cpu(void)
{
    static char wide[] = "SKYLAKEX", narrow[] = "HASWELL";

#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw"))
        return wide;
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return narrow;
#endif
    (void)wide, (void)narrow;
    return NULL;
}

/* Answers the C library's getenv, also when OpenBLAS calls it while it is loaded: in main
 * it would be too late. The program uses one thread of OpenBLAS, which else starts more,
 * and waits for ever for those that a limit on memory does not allow; without a given
 * kernel it takes a slow one on CPUs newer than itself. */
char *getenv(const char *name)
{
    static char one[] = "1";
    const size_t length = strlen(name);

    if (!strcmp(name, "OPENBLAS_NUM_THREADS"))
        return one;
    for (char **at = environ; at && *at; at++)
        if (!strncmp(*at, name, length) && (*at)[length] == '=')
            return *at + length + 1;
    return strcmp(name, "OPENBLAS_CORETYPE") ? NULL : kernel_for_cpu();
}

int main(int argc, char **argv)
{
    struct message why = {{0}}, lost = {{0}};

    if (!threads_are_few(&why)) {
        fprintf(stderr, "clothbench: %s\n", why.text);
        return EXIT_USAGE;
    }
    blas_kernel_set_threads(1);
    const char *threads = getenv("OMP_NUM_THREADS");
    if (!threads || !*threads)
        omp_set_num_threads(1); /* timings use one thread unless set otherwise */
    /* Output is buffered by line, so that no standard error stands inside a line of
     * results. */
    setvbuf(stdout, NULL, _IOLBF, 0);
    output_keep_after_closed_pipe();
    atomic_file_catch_signals();

    enum status st = run(argc - 1, argv + 1, &why);
    enum status written = output_close_standard(&lost);
    if (written != STATUS_OK && (st == STATUS_OK || !*why.text)) {
        st = written;
        why = lost;
    }
    if (st != STATUS_OK)
        fprintf(stderr, "clothbench: %s\n", *why.text ? why.text : status_text(st));
    return exit_code(st);
}
