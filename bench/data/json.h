/* json.h - texts as JSON. */
#ifndef JSON_H
#define JSON_H

#include <stdio.h>

/* Prints a text with its quotes. */
void json_string(const char *text, FILE *file);

#endif
