/* truth_file.h - truths that are stored: result files (store.h) with a few numbers more.
 *
 * NAME.h5 is the truth of the scene NAME. Besides what a result file has:
 *
 *   attributes    note       where the field comes from, and its error bar, as a sentence
 *                 horizon    until when the motion is predictable, a sentence
 *                 physics    truth_physics.h: what it holds for
 *                 checksum   of physics, times, numbers and fields: a file that was changed
 *                            is refused
 *   metrics/NAME  [F]        truth_made.h's columns, at all times
 *   xyz           [K]        float; only at the K times before the horizon
 *
 * third/NAME.h5 beside it, if it is there, is what a third mechanics has instead
 * (truth_third.h), in the same layout: whoever reads a truth gets it as that leaves it.
 */
#ifndef TRUTH_FILE_H
#define TRUTH_FILE_H

#include "bench/files/provenance.h"
#include "bench/truth/truth_made.h"
#include "models/reader/named_file.h"

/* Where stored truths are: $CLOTHBENCH_TRUTHS first. */
extern const struct named_file_kind truth_file_kind;

/* Writes what was made. */
enum status truth_file_write(const char *path, const struct truth_runs *runs,
                             const struct truth_made *made, struct message *why);

/* The third's file of a truth's. STATUS_INPUT: third[size] is too short. */
enum status truth_file_third(const char *path, char *third, size_t size,
                             struct message *why);

/* Whether a program of this commit and so many changed files makes truths that may come
 * with it; and whether such a one may write FILE: not where those are that do, unless it
 * does. STATUS_INPUT with a sentence. */
bool truth_file_clean(const char *commit, const char *changed);
enum status truth_file_may_store(const char *path, const struct provenance *program,
                                 struct message *why);

/* The stored truth of a name, if it is of this scene's physics. STATUS_FILE: none is
 * stored; STATUS_UNSUPPORTED: it is of other physics; STATUS_INPUT: it was changed; with a
 * sentence each. Free with truth_made_clear. */
enum status truth_file_find(const char *name, const struct scene *scene,
                            struct truth_made *made, struct message *why);

/* Reads one; the fields past the horizon are NULL, `level` is left zero. *physics is freed
 * by the receiver. STATUS_INPUT with a sentence: no truth, or changed, or the third
 * mechanics beside it is. Free with truth_made_clear. */
enum status truth_file_read(const char *path, struct truth_made *made, char **physics,
                            struct message *why);

#endif
