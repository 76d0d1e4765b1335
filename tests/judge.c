/* How sentences turn, and how a folder of a quick run is told from a full one. */
#include "bench/experiment/judge.h"

#include "bench/files/folder.h"
#include "tests/check.h"

static const struct {
    double value[4];
    int count, sign;
    double bar;
    enum judge turn;
} orders[] = {
    {{1, 2, 3, 4}, 4, 1, 0, JUDGE_HOLDS},
    {{4, 3, 2, 1}, 4, 1, 0, JUDGE_FAILS},
    {{4, 3, 2, 1}, 4, -1, 0, JUDGE_HOLDS},
    {{1, 2, 3, 4}, 4, -1, 0, JUDGE_FAILS},
    {{1, 2, 2, 4}, 4, 1, 0, JUDGE_FAILS}, /* no more is not more */
    {{1, 2, 3, 3}, 4, 1, 0, JUDGE_FAILS},
    {{1, 2, 3, 2}, 3, 1, 0, JUDGE_HOLDS}, /* the fourth is not asked for */
    {{1, NAN, 3, 4}, 4, 1, 0, JUDGE_OPEN},
    {{NAN, 2, 3, 4}, 4, 1, 0, JUDGE_OPEN},
    {{1, 2, 3, NAN}, 4, 1, 0, JUDGE_OPEN},
    {{3, NAN, 1, 4}, 4, 1, 0, JUDGE_FAILS}, /* across the one that is missing */
    {{NAN, 3, 1, 4}, 4, 1, 0, JUDGE_FAILS},
    {{NAN, NAN}, 2, 1, 0, JUDGE_OPEN},
    {{1, 1.2, 1.4}, 3, 1, 0.1, JUDGE_HOLDS},
    {{1, 1.2, 1.25}, 3, 1, 0.1, JUDGE_OPEN}, /* within the bar */
    {{1, 1.2, 1.15}, 3, 1, 0.1, JUDGE_OPEN},
    {{1, 1.2, 1.2}, 3, 1, 0.1, JUDGE_OPEN},
    {{1, 1.2, 1.05}, 3, 1, 0.1, JUDGE_FAILS},
    {{1.05, 1, 1.3, 1.1}, 4, 1, 0.1, JUDGE_FAILS}, /* what is settled stays so */
    {{1, 2, 3}, 3, 1, NAN, JUDGE_OPEN},
    {{3, 2, 1}, 3, 1, NAN, JUDGE_OPEN},
    {{1}, 1, 1, 0, JUDGE_OPEN}, /* nothing to compare with */
};

static const struct {
    double value, bound;
    enum judge turn;
} bounds[] = {{1, 2, JUDGE_HOLDS},       {2, 1, JUDGE_FAILS},  {1, 1, JUDGE_FAILS},
              {NAN, 1, JUDGE_OPEN},      {1, NAN, JUDGE_OPEN}, {-2, -1, JUDGE_HOLDS},
              {1, INFINITY, JUDGE_HOLDS}};

/* Of two, in either order. */
static const enum judge both[][3] = {
    {JUDGE_HOLDS, JUDGE_HOLDS, JUDGE_HOLDS}, {JUDGE_HOLDS, JUDGE_FAILS, JUDGE_FAILS},
    {JUDGE_HOLDS, JUDGE_OPEN, JUDGE_OPEN},   {JUDGE_FAILS, JUDGE_OPEN, JUDGE_FAILS},
    {JUDGE_FAILS, JUDGE_FAILS, JUDGE_FAILS}, {JUDGE_OPEN, JUDGE_OPEN, JUDGE_OPEN},
    {JUDGE_HOLDS, JUDGE_QUICK, JUDGE_QUICK}, {JUDGE_FAILS, JUDGE_QUICK, JUDGE_FAILS}};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void turns(void)
{
    for (size_t n = 0; n < COUNT(orders); n++)
        if (!CHECK(judge_order(orders[n].count, orders[n].value, orders[n].sign,
                               orders[n].bar) == orders[n].turn))
            printf("order %zu\n", n);
    for (size_t n = 0; n < COUNT(bounds); n++)
        if (!CHECK(judge_below(bounds[n].value, bounds[n].bound) == bounds[n].turn))
            printf("bound %zu\n", n);
    for (size_t n = 0; n < COUNT(both); n++)
        if (!CHECK(judge_both(both[n][0], both[n][1]) == both[n][2]) ||
            !CHECK(judge_both(both[n][1], both[n][0]) == both[n][2]))
            printf("both %zu\n", n);
    for (enum judge turn = JUDGE_FAILS; turn <= JUDGE_QUICK; turn++) {
        const char *const want[] = {"no", "yes", "perhaps", "perhaps"};
        CHECK(!strcmp(judge_words(turn, "yes", "no", "perhaps"), want[turn]));
    }
    CHECK(judge_most(1, 2) == 2 && judge_most(2, 1) == 2);
    CHECK(isnan(judge_most(NAN, 1)) && isnan(judge_most(1, NAN)));
}

static void words(void)
{
    static const char want[] = "- \"more is more\": does not hold. 1 is less than 2.\n\n"
                               "- \"q\": holds. x\n\n- \"q\": cannot be judged. x\n\n"
                               "- \"q\": not judged: quick. x\n\n";
    char *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);

    REQUIRE(file);
    judge_print(file, "more is more", JUDGE_FAILS, "%d is less than %d.", 1, 2);
    for (enum judge turn = JUDGE_HOLDS; turn <= JUDGE_QUICK; turn++)
        judge_print(file, "q", turn, "x");
    fclose(file);
    CHECK(!strcmp(text, want));
    free(text);
}

static void says(const char *folder, const char *want)
{
    char path[4096], text[128] = "";

    snprintf(path, sizeof path, "%s/quick.txt", folder);
    FILE *file = fopen(path, "r");
    REQUIRE(file && fgets(text, sizeof text, file));
    CHECK(!strcmp(text, want));
    fclose(file);
}

static void marks(const char *folder)
{
    REQUIRE(folder_make(folder, NULL) == STATUS_OK);
    judge_mark(folder, true);
    CHECK(judge_marked(folder));
    says(folder, "these results are of a run with --quick\n");
    judge_mark(folder, false);
    CHECK(!judge_marked(folder));
    judge_mark(folder, false); /* which was not there */
    CHECK(!judge_marked(folder));
}

int main(int count, char **arguments)
{
    REQUIRE(count == 2);
    turns();
    words();
    marks(arguments[1]);
    return check_result();
}
