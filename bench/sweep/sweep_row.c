#define _DEFAULT_SOURCE /* strsep */
#include "bench/sweep/sweep_row.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/seal.h"

bool sweep_row_is_open(const struct sweep_row *row)
{
    return row->state == SWEEP_ROW_GONE || row->state == SWEEP_ROW_DAMAGED ||
           row->state == SWEEP_ROW_CUT;
}

#define MADE_FOR "case %08lx plan %08lx program %08lx"

const char *sweep_row_made_for(const struct sweep_folder *folder, const struct plan *plan,
                               const struct plan_case *c, char text[SWEEP_ROW_MADE_FOR])
{
    unsigned long sum = 0;

    for (int k = 0; k < plan->key_count; k++) {
        const struct plan_setting *s = c->given[k];
        if (!s)
            continue;
        sum = seal_text_sum(sum, s->key, strlen(s->key) + 1);
        sum = seal_text_sum(sum, s->value, strlen(s->value) + 1);
    }
    snprintf(text, SWEEP_ROW_MADE_FOR, MADE_FOR, sum, folder->plan, folder->program);
    return text;
}

/* What a file that was made for `is` has of another, being wanted for `want`. */
static void tell_foreign(const char *path, const char *is, const char *want,
                         struct message *why)
{
    unsigned long a[3] = {0}, b[3] = {0};

    sscanf(is, MADE_FOR, &a[0], &a[1], &a[2]);
    sscanf(want, MADE_FOR, &b[0], &b[1], &b[2]);
    status_fail(why, STATUS_INPUT,
                "%s: is of another %s; take it away, or give another folder with --out",
                path,
                a[2] != b[2]   ? "build of the program"
                : a[1] != b[1] ? "plan or scene"
                               : "case");
}

/* The parts of a sentence's file. */
static enum sweep_row_state read_sentence(char *text, const char *path,
                                          const char *made_for, struct message *why)
{
    static const char *const word[] = {
        [SWEEP_ROW_CUT] = "cut", [SWEEP_ROW_FAILED] = "failed"};
    char *rest = text;
    const char *is = strsep(&rest, "\n"), *state = strsep(&rest, "\n");
    const char *sentence = strsep(&rest, "\n");

    for (int n = SWEEP_ROW_CUT; sentence && n <= SWEEP_ROW_FAILED; n++) {
        if (strcmp(state, word[n]) != 0)
            continue;
        if (made_for && strcmp(is, made_for) != 0) {
            tell_foreign(path, is, made_for, why);
            return SWEEP_ROW_FOREIGN;
        }
        snprintf(why->text, sizeof why->text, "%s%s", sentence,
                 n == SWEEP_ROW_CUT ? "; --resume runs it again" : "");
        return (enum sweep_row_state)n;
    }
    return SWEEP_ROW_DAMAGED;
}

static enum status read_text(const char *path, const char *made_for, struct sweep_row *row)
{
    char *text = NULL;

    if (access(path, F_OK) != 0) {
        row->state = SWEEP_ROW_GONE;
        snprintf(row->why.text, sizeof row->why.text,
                 "its file is gone; --resume runs it again");
        return STATUS_OK;
    }
    const enum status st = seal_text_read(path, &text, NULL);
    if (st == STATUS_OK)
        row->state = read_sentence(text, path, made_for, &row->why);
    free(text);
    return st;
}

static enum status read_result(const char *path, const char *made_for, bool fields,
                               struct sweep_row *row)
{
    struct run_result *r = &row->result;
    const enum status st = run_result_read(path, fields, r, NULL);

    if (st != STATUS_OK)
        return st;
    row->state = r->outcome == STATUS_INPUT ? SWEEP_ROW_FAILED : SWEEP_ROW_RAN;
    row->why = r->sentence;
    if (made_for && strcmp(r->made_for, made_for) != 0) {
        row->state = SWEEP_ROW_FOREIGN;
        tell_foreign(path, r->made_for, made_for, &row->why);
        run_result_clear(r);
    }
    return STATUS_OK;
}

enum status sweep_row_read(const struct sweep_folder *folder, long number,
                           const char *made_for, bool fields, struct sweep_row *row)
{
    char path[SWEEP_FOLDER_PATH];
    enum status st;

    *row = (struct sweep_row){.state = SWEEP_ROW_DAMAGED};
    sweep_folder_file(folder, number, "h5", path);
    if (access(path, F_OK) == 0) {
        st = read_result(path, made_for, fields, row);
    } else {
        sweep_folder_file(folder, number, "txt", path);
        st = read_text(path, made_for, row);
    }
    if (st == STATUS_MEMORY) {
        *row = (struct sweep_row){0};
        return st;
    }
    if (row->state == SWEEP_ROW_DAMAGED)
        snprintf(row->why.text, sizeof row->why.text,
                 "its file is damaged; --resume runs it again");
    return STATUS_OK;
}

enum status sweep_row_write(const struct sweep_folder *folder, long number,
                            const char *made_for, enum sweep_row_state state,
                            const char *sentence, struct message *why)
{
    char path[SWEEP_FOLDER_PATH], text[SWEEP_ROW_MADE_FOR + sizeof why->text + 16];

    sweep_folder_file(folder, number, "txt", path);
    snprintf(text, sizeof text, "%s\n%s\n%s\n", made_for,
             state == SWEEP_ROW_CUT ? "cut" : "failed", sentence);
    return seal_text_write(path, text, why);
}

void sweep_row_remove(const struct sweep_folder *folder, long number)
{
    static const char *const endings[] = {"h5", "xdmf", "txt"};
    char path[SWEEP_FOLDER_PATH];

    for (size_t n = 0; n < sizeof endings / sizeof *endings; n++) {
        sweep_folder_file(folder, number, endings[n], path);
        unlink(path);
    }
}
