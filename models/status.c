#include "models/status.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>

const char *status_text(enum status st)
{
    static const char *const text[] = {
#define STATUS_SENTENCE(code, sentence) [STATUS_##code] = sentence,
        STATUS_LIST(STATUS_SENTENCE)
#undef STATUS_SENTENCE
    };
    return (unsigned)st < sizeof text / sizeof *text ? text[st] : "unknown status";
}

bool status_is_death(enum status st)
{
    return st >= STATUS_NAN;
}

void status_join(char *text, size_t size, const char *between, const char *format, ...)
{
    size_t used = strlen(text);
    va_list args;

    if (used)
        used += (size_t)snprintf(text + used, size - used, "%s", between);
    va_start(args, format);
    if (used < size)
        vsnprintf(text + used, size - used, format, args);
    va_end(args);
}

enum status status_fail(struct message *why, enum status st, const char *format, ...)
{
    if (why) {
        va_list args;
        va_start(args, format);
        vsnprintf(why->text, sizeof why->text, format, args);
        va_end(args);
        for (char *c = why->text; *c; c++) /* names from files must not rule a terminal */
            *c = iscntrl((unsigned char)*c) ? '?' : *c;
    }
    return st;
}
