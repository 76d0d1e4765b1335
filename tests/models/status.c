/* Status codes: every code has a sentence, deaths are told from errors. */
#include "models/status.h"
#include "tests/check.h"

int main(void)
{
    struct message why;

#define CHECK_CODE(code, sentence) CHECK(!strcmp(status_text(STATUS_##code), sentence));
    STATUS_LIST(CHECK_CODE)
    CHECK(!strcmp(status_text((enum status)999), "unknown status"));
    CHECK(!status_is_death(STATUS_OK) && !status_is_death(STATUS_INPUT));
    CHECK(status_is_death(STATUS_NAN) && status_is_death(STATUS_ESCAPED));

    CHECK(status_fail(&why, STATUS_INPUT, "%s:%d", "file", 7) == STATUS_INPUT);
    CHECK(!strcmp(why.text, "file:7"));
    status_fail(&why, STATUS_INPUT, "a\n\033[2J\x7f");
    CHECK(!strcmp(why.text, "a??[2J?")); /* one line, which a terminal does not obey */
    CHECK(status_fail(NULL, STATUS_FILE, "unread") == STATUS_FILE);
    return check_result();
}
