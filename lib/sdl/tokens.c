#include "sdl/tokens.h"

typedef struct row { const char *name; uint32_t flags; } row;

#define TOKEN_ROW(name, text, flags) { text, flags },
static const row keywords[KEYWORDS] = { { "", 0 }, TOKEN_KEYWORDS(TOKEN_ROW) };
#undef TOKEN_ROW

const char *token_keyword_name(keyword_id id)
{
    return keywords[id].name;
}

uint32_t token_keyword_flags(keyword_id id)
{
    return keywords[id].flags;
}
