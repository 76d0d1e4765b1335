/* settings_text.h - a discretization spelled the way --set takes it. */
#ifndef SETTINGS_TEXT_H
#define SETTINGS_TEXT_H

#include "models/discretization.h"

/* Lines `discretization.key=value`, every key, 17 digits; *text is freed by the receiver.
 */
enum status settings_text(const struct discretization *d, char **text);

#endif
