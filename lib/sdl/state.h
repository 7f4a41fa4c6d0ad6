/* state.h - what reading a text needs to know, and the steps from token to token. */
#ifndef SDL_STATE_H
#define SDL_STATE_H

#include "model/model.h"
#include "plug/registry.h"
#include "sdl/lex.h"

/* Braces that are open, innermost first; they live on the stack of the function that reads them. */
typedef struct block {
    place keyword, brace;
    struct block *outer;
} block;

/* A camera as written; which way it looks depends on the dialect, which the end of the text decides. */
typedef struct camera_text {
    place at;                    /* of its keyword; source NULL: there is none */
    place look_at_place;
    pov_vec3 location, look_at, direction, right, up, sky;
    double angle;                /* degrees; 0: none */
    bool has_look_at;
    const transform *map;
} camera_text;

typedef struct settings_text {
    bool has_ambient_light;
    double assumed_gamma;        /* 0: none */
    double version;              /* 0: none was set */
} settings_text;

/* Words that a plugin asked for and that were not there: what the word that is there may have been meant as.
 * */
enum { TRIED_MAX = 4, TRIED_LENGTH = 24 };

struct pov_reader {
    model *model;
    registry *plugins;
    symbols words;
    lex lex;
    token token;                 /* the next one, not taken yet */
    place last;                  /* the one that was taken last; source NULL: none was */
    place value;                 /* where the value that was read last begins */
    block *block;
    bool in_directive;           /* a '#' waits until the directive before it has been read */
    bool failed;                 /* from here on every token is the end of the text */
    pov_error error;
    pov_dialect wanted_dialect;
    place povray_word;           /* the first word that makes the file `povray`; source NULL: none yet */
    camera_text camera;
    settings_text settings;
    uint32_t *material_slots;    /* a hash table of the model's materials: index + 1, 0 is empty */
    size_t material_capacity;
    char tried[TRIED_MAX][TRIED_LENGTH];
    int tried_count;
};

/* Take the token and fetch the next. */
void state_advance(pov_reader *in);

static inline bool state_at_end(const pov_reader *in)
{
    return in->token.kind == TOKEN_END;
}

/* Take the mark if it is next. */
static inline bool state_accept(pov_reader *in, int mark)
{
    if (in->token.kind != mark)
        return false;
    state_advance(in);
    return true;
}

/* The word that is next, or WORD_OTHER. */
static inline word_id state_word(const pov_reader *in)
{
    return in->token.symbol ? in->token.symbol->id : WORD_OTHER;
}

/* Take the mark or fail: `expected ">" after ...`. */
void state_expect(pov_reader *in, int mark);
/* The place from the token on makes the file `povray`, unless one did before. */
void state_note_povray(pov_reader *in, const place *word);
/* Memory of the scene, zeroed. NULL: none, and the reader has failed. */
void *state_alloc(pov_reader *in, size_t bytes, size_t align);

#endif
