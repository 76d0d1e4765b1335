/* Commands take as many words as their usage lines say: "SCENE [OPTION]..." takes
 * one, "[CASE]... [OPTION]..." any number of its items. More and fewer are refused. */
#include "bench/commands.h"

#include "tests/check.h"

/* Words that the line asks for, and the most that it allows; -1: any number. */
static void read_usage(const char *usage, int *least, int *most)
{
    char text[256];

    *least = *most = 0;
    snprintf(text, sizeof text, "%s", usage);
    for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
        if (!strncmp(word, "[OPTION]", 8))
            continue;
        *least += *word != '[';
        *most = strstr(word, "...") ? -1 : *most + 1;
    }
}

static enum status parse(const struct command *c, int count)
{
    enum { MOST = 100001 };
    static char *words[MOST];
    struct command_line line;
    struct message why = {""};

    for (int n = 0; n < MOST; n++)
        words[n] = "word";
    REQUIRE(count >= 0 && count <= MOST);
    const enum status st = command_parse(c, count, words, &line, &why);
    CHECK(st == STATUS_OK ? line.word_count == count : *why.text != '\0');
    command_line_clear(&line);
    return st;
}

int main(void)
{
    int count = 0;

    for (const struct command *const *c = commands; *c; c++, count++) {
        int least, most, items = 0;
        read_usage((*c)->arguments, &least, &most);
        while ((*c)->items && (*c)->items[items])
            items++;
        if (most < 0) /* each of its items may be named, or one and so many words of it */
            most = (*c)->most >= items || least ? (*c)->most : items;
        if (!CHECK((*c)->least == least && (*c)->most == most))
            printf("%s takes %d to %d words\n", (*c)->name, (*c)->least, (*c)->most);
        CHECK(parse(*c, least) == STATUS_OK && parse(*c, most) == STATUS_OK);
        CHECK(parse(*c, most + 1) == STATUS_INPUT);
        CHECK(least == 0 || parse(*c, least - 1) == STATUS_INPUT);
    }
    CHECK(count > 5);
    return check_result();
}
