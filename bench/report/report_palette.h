/* report_palette.h - a picture in a palette: a tenth of the bytes of one in full colour. */
#ifndef REPORT_PALETTE_H
#define REPORT_PALETTE_H

#include <stddef.h>

/* The bytes of a PNG of 8-bit red, green and blue as one of 256 colours: those of which it
 * has most, to five bits a component, each the mean of what it stands for; any other
 * becomes the nearest of them. Freed by the receiver; NULL: it is not of this kind, is
 * damaged, would be no smaller, or memory is out. */
unsigned char *report_palette_pack(const unsigned char *png, size_t size, size_t *packed);

#endif
