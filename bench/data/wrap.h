/* wrap.h - words on a screen: how wide they are, and sentences in lines of at most its
 * width.
 */
#ifndef WRAP_H
#define WRAP_H

#include <stdio.h>

/* The most columns of the screen for a sentence, and for any line. */
enum { WRAP_WIDTH = 96, WRAP_LINE = 120 };

/* Returns the columns that words take on a screen: bytes that do not continue a character
 * of UTF-8; 0 for NULL. */
int wrap_width(const char *text);

/* Prints a character; one that could rule a terminal, from the name of a file, as `?`. */
void wrap_put(unsigned char c, FILE *file);

/* Prints words in lines up to `width`, all but the first after `indent` blanks, which must
 * already stand before the first. */
void wrap_words(const char *text, int indent, int width, FILE *file);

/* Prints words in lines of a sentence's width, then a line end. */
void wrap_print(const char *text, FILE *file);

/* Prints a name, and from this column on text, wrapped to the width of a line of tables. */
void wrap_item(const char *name, int column, const char *text, FILE *file);

/* Prints printf's words wrapped: a sentence beside the tables, in a line of its own. */
void wrap_say(FILE *file, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
