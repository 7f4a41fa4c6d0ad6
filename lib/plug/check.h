/* check.h - does a plugin keep the form of the contract? */
#ifndef PLUG_CHECK_H
#define PLUG_CHECK_H

#include <povtrace/plugin.h>

/* NULL when it does, else what is wrong, in words for a message. */
const char *check_plugin(const pov_plugin *plugin);

#endif
