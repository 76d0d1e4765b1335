/* fuzz.h - what fuzz targets share. A target is one LLVMFuzzerTestOneInput, built twice:
 * with libFuzzer (fuzz_NAME), and with replay.c, as a test that reads a kept corpus.
 *
 *   cmake --preset fuzz && cmake --build --preset fuzz
 *   cp -r tests/corpus/scene corpus && cp models/scenes/ *.yaml tests/bad_scenes/ *.yaml
 * corpus
 *   build-fuzz/tests/fuzz_scene -dict=tests/fuzz_scene.dict -max_len=4096 \
 *       -max_total_time=600 corpus
 *
 * and likewise fuzz_plan, fuzz_store and fuzz_frames with their own corpus and dictionary,
 * and fuzz_mesh with its corpus.
 */
#ifndef FUZZ_H
#define FUZZ_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/status.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* What was read must hold: stop with the failed condition's text. */
#define MUST(condition)                                                                    \
    do {                                                                                   \
        if (!(condition)) {                                                                \
            fprintf(stderr, "does not hold: %s\n", #condition);                            \
            abort();                                                                       \
        }                                                                                  \
    } while (0)

/* One line without control characters, for people. */
static inline bool fuzz_is_line(const char *text)
{
    for (const unsigned char *c = (const unsigned char *)text; *c; c++)
        if (*c < ' ' || *c == 127)
            return false;
    return true;
}

static inline void fuzz_check_sentence(const struct message *why, const char *beginning)
{
    MUST(strlen(why->text) > 8 && strlen(why->text) < sizeof why->text - 1);
    MUST(fuzz_is_line(why->text));
    MUST(!strncmp(why->text, beginning, strlen(beginning)));
}

#endif
