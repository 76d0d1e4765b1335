/* The reader of FreeFEM's fields refuses every bad one. (What they hold: `clothbench verify
 * cantilever` and `transient`.) */
#include "fem_ref/freefem.h"
#include "tests/scratch.h"
#include "tests/text.h"

static const char rests[] = REFERENCE_DIR "/freefem_static_h10mm.csv",
                  moves[] = REFERENCE_DIR "/freefem_transient_h1mm.csv";
static struct freefem_field field;

static const char *bad;

static char *whole(const char *path)
{
    static char text[1 << 18];
    FILE *file = fopen(path, "rb");
    REQUIRE(file != NULL);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    return text;
}

/* The static field with its n-th data row (1-based) replaced. */
static void put_row(int n, const char *row)
{
    char *text = whole(rests), *at = strstr(text, "\nu,v,");
    REQUIRE(at != NULL);
    at++;
    for (int i = 0; i < n; i++)
        at = strchr(at, '\n') + 1;
    char *rest = strchr(at, '\n') + 1;
    FILE *file = fopen(bad, "wb");
    REQUIRE(file != NULL);
    fprintf(file, "%.*s%s%s", (int)(at - text), text, row, rest);
    REQUIRE(!fclose(file));
}

static void check_bad(const char *word)
{
    struct message why = {""};
    field.times = -1;
    CHECK(freefem_read(bad, &field, &why) == STATUS_INPUT);
    CHECK(field.times == -1); /* untouched */
    CHECK_SAY(strstr(why.text, word) && strstr(why.text, bad), "said: %s", why.text);
}

static void check_fields(void)
{
    static const struct {
        int row;
        const char *text, *word;
    } want[] = {
        {2, "0.090909090909090912,0,0,0,nan\n", "row 2: a displacement is not a finite"},
        {144, "1,1,0,0,inf\n", "row 144: a displacement is not a finite number"},
        {144, "1,1,0,0,-1e999\n", "not a finite number"},
        {2, "0.1,0,0,0,-0.1\n", "row 2: another point"},
        {1, "0,0,0,0,1e-9\n", "row 1: the clamped edge moves"},
        {7, "0.54545454545454541,0,0,0,0\n", "row 7: a point does not move"},
        {144, "", "143 rows, not 144"},
        {144, "1,1,0,0,-1\n1,1,0,0,-1\n", "145 rows, not 144"},
        {144, "1,1,0,0\n", "4 cells below 5 keys"},
        {144, "1,1,0,0,-0.6", "cut short"}};
    struct message why;

    CHECK(freefem_read("/no/such/file", &field, &why) == STATUS_FILE);
    for (size_t n = 0; n < sizeof want / sizeof *want; n++) {
        put_row(want[n].row, want[n].text);
        check_bad(want[n].word);
    }
    text_write(bad, "");
    check_bad("no rows");
    text_write(bad, "u,v,dx,dy\n0,0,0,0\n");
    check_bad("no column dz");
    char *text = whole(moves);
    memcpy(strstr(text, "\n0.2000"), "\n0.3", 4); /* the first row of 0.2 s */
    text_write(bad, text);
    check_bad("row 145: another time");
}

/* The notes' errors, and the times of a field that moves or rests. */
static void check_notes(void)
{
    REQUIRE(!freefem_read(moves, &field, NULL));
    CHECK(field.times == 4 && field.time[3] == 0.4);
    for (int t = 0; t < 4; t++)
        CHECK(field.error[t] > 0 && field.error[t] < 1e-3);
    REQUIRE(!freefem_read(rests, &field, NULL));
    CHECK(field.times == 1 && isinf(field.time[0]));
}

int main(void)
{
    scratch_open();
    bad = scratch_path("bad.csv");
    check_fields();
    check_notes();
    CHECK(scratch_files(scratch) == 1);
    return check_result();
}
