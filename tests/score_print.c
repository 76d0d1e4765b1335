/* What `score` prints of made-up results: every number in its own column, in CSV and in
 * JSON, only times that frames tell of, and how many of them lie between frames. */
#include "bench/score/score_print.h"

#include <stdlib.h>
#include <string.h>

#include "tests/check.h"

static const struct score_time times[] = {
    {.time = .1, .known = true, .error = .01, .bar = .02, .floor = .03},
    {.time = .2, .known = false, .error = .04, .bar = .05, .floor = .06},
    {.time = .3, .known = true, .between = true, .error = .07, .bar = .08, .floor = .09}};

static const struct {
    enum table_format format;
    const char *words;
} row[] = {{TABLE_CSV, "drop,0.10000000000000001,0.01,0.02,0.029999999999999999\n"
                       "drop,0.29999999999999999,0.070000000000000007,0.080000000000000002,"
                       "0.089999999999999997\n"},
           {TABLE_JSON, "\"error\": 0.01, \"bar\": 0.02, \"floor\": 0.029999999999999999}, "
                        "{\"scene\": \"drop\", \"time\": 0.29999999999999999"},
           {TABLE_JSON,
            "truth at 3 times from 0.1 to 0.3 s; judged at the 2 where both exist, at 1 "
            "of them between frames"}};

int main(void)
{
    struct score_result r = {.times = 3, .frames = 7, .vertices = 9};
    char text[4096];

    REQUIRE((r.scene = strdup("drop")) && (r.row = malloc(sizeof times)));
    memcpy(r.row, times, sizeof times);
    for (size_t n = 0; n < sizeof row / sizeof *row; n++) {
        FILE *file = tmpfile();
        REQUIRE(file && score_print(&r, 1, row[n].format, file) == STATUS_OK);
        rewind(file);
        text[fread(text, 1, sizeof text - 1, file)] = '\0';
        if (!CHECK(strstr(text, row[n].words)))
            printf("'%s' is not in\n%s", row[n].words, text);
        fclose(file);
    }
    score_result_clear(&r);
    return check_result();
}
