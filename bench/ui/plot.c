#include "bench/ui/plot.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

enum { NOT_FOUND = 127, PATH = 4096 };

/* Refuses a name in which a shell or gnuplot, which takes '|...' for a command, would see
 * more than a name. */
static enum status check_name(const char *name, struct message *why)
{
    bool plain = isalnum((unsigned char)*name);

    for (const char *c = name; *c; c++)
        plain = plain && (isalnum((unsigned char)*c) || strchr("_-.", *c));
    return plain ? STATUS_OK
                 : status_fail(why, STATUS_INPUT,
                               "plot '%s': a name has letters, digits, _, - and . only",
                               name);
}

enum status plot_begin(const char *folder, const char *name, struct output **out,
                       struct message *why)
{
    char path[PATH];
    enum status st;

    TRY(check_name(name, why));
    snprintf(path, sizeof path, "%s/%s.gp", folder, name);
    TRY(output_create(path, out, why));
    fputs("set encoding utf8\n", output_stream(*out));
out:
    return st;
}

/* Sizes are those of a screen of 96 points an inch; so is the type. */
void plot_page(FILE *script, const char *name, enum plot_kind kind, int width, int height)
{
    static const struct {
        const char *ending, *terminal, *unit, *font, *scale;
        double per; /* points a unit */
    } of[] = {{"png", "pngcairo", "", "'Sans,10'", "1.", 1},
              {"svg", "svg", "", "'Sans,13'", "0.6", 1},
              {"pdf", "pdfcairo", "in",
               "'Sans,10' fontscale 0.75 linewidth 1.4 dashlength 1.4", "1.", 96}};

    fprintf(script,
            "unset multiplot\nunset output\nreset\n"
            "set terminal %s noenhanced size %g%s,%g%s font %s\nscale = %s\n"
            "set output '%s.%s'\n",
            of[kind].terminal, width / of[kind].per, of[kind].unit, height / of[kind].per,
            of[kind].unit, of[kind].font, of[kind].scale, name, of[kind].ending);
}

/* Writes a string in '', within which only ' itself is special; that character is written
 * within "" instead, since doubled at the start it would end the string. */
static void write_text(FILE *script, const char *text, const char *line_end)
{
    fputc('\'', script);
    for (; *text; text++)
        if (*text == '\n')
            fputs(line_end, script);
        else if (*text == '\'')
            fputs("'.\"'\".'", script);
        else
            fputc(iscntrl((unsigned char)*text) ? ' ' : *text, script);
    fputc('\'', script);
}

void plot_line(FILE *script, const char *text)
{
    write_text(script, text, " ");
}

void plot_lines(FILE *script, const char *text)
{
    write_text(script, text, "'.\"\\n\".'");
}

static enum status run_script(const char *folder, const char *script, struct message *why)
{
    int code;
    pid_t child = fork();

    if (child < 0)
        return status_fail(why, STATUS_LIBRARY, "gnuplot cannot be started");
    if (child == 0) {
        setenv("LC_ALL", "C.UTF-8", 1); /* our encoding; under C it warns of that */
        if (chdir(folder) == 0)
            execlp("gnuplot", "gnuplot", "-d", script, (char *)NULL);
        _exit(NOT_FOUND);
    }
    if (waitpid(child, &code, 0) < 0 || !WIFEXITED(code))
        return status_fail(why, STATUS_LIBRARY, "gnuplot was ended by a signal");
    if (WEXITSTATUS(code) == NOT_FOUND)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "no plot: gnuplot is not installed (Debian: gnuplot-nox)");
    if (WEXITSTATUS(code))
        return status_fail(why, STATUS_LIBRARY, "gnuplot failed on %s/%s", folder, script);
    return STATUS_OK;
}

enum status plot_end(const char *folder, const char *name, struct output **out,
                     struct message *why)
{
    char script[PATH];
    enum status st;

    fputs("unset multiplot\nunset output\n", output_stream(*out));
    TRY(output_close(out, why));
    snprintf(script, sizeof script, "%s.gp", name);
    TRY(run_script(folder, script, why));
out:
    return st;
}

enum status plot_tell(enum status st, const char *folder, const char *name,
                      const char *endings, const struct message *plot, struct message *why)
{
    if (st == STATUS_OK)
        fprintf(stderr, "%s%s in %s\n", name, endings, folder);
    else if (st != STATUS_UNSUPPORTED && st != STATUS_LIBRARY)
        return status_fail(why, st, "%s", *plot->text ? plot->text : status_text(st));
    else
        fprintf(stderr, "%s: %s\n", name, plot->text);
    return STATUS_OK;
}
