/* html.h - writes pages: markup is the program's own, and every text that is
 * put into it is escaped, wherever it comes from. */
#ifndef HTML_H
#define HTML_H

#include <stdio.h>

#include "models/status.h"

struct output;

/* Writes markup, in which %s is a text, escaped for elements and quoted attributes, %d a
 * whole number, %g a number to three digits ("-" where there is none), and %% a per cent
 * sign; nothing else. Bytes that are not UTF-8 stay, which browsers show as the replacement
 * character. */
void html_print(FILE *file, const char *markup, ...) __attribute__((format(printf, 2, 3)));

/* Writes the begin of a page: its title, in two parts. */
void html_head(FILE *file, const char *title, const char *more);

/* Starts the page FOLDER/KIND_NAME.html, or FOLDER/NAME.html without a kind: its title as a
 * heading, and the links that all pages have. Finishes it; *out is NULL then. STATUS_INPUT
 * with a sentence: the path is too long; STATUS_FILE. */
enum status html_open(const char *folder, const char *kind, const char *name,
                      const char *title, struct output **out, struct message *why);
enum status html_close(struct output **out, struct message *why);

/* Writes the begin of a table that scrolls within the page, its heads given as
 * "text|number": names of columns of words begin with '<'. Rows and html_table_end
 * follow. */
void html_table(FILE *file, const char *heads);
void html_table_end(FILE *file);

/* Reads page.html, which comes with the program, up to the mark of its data and behind it,
 * *rest; *page is freed by the receiver. Writes the CSS of all pages, which is there.
 * STATUS_INPUT with a sentence: there is no such page of ours; STATUS_MEMORY. */
enum status html_page_read(char **page, char **rest, struct message *why);
enum status html_style(FILE *file, struct message *why);

#endif
