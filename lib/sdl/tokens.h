/* tokens.h - the words of the language, and the token that the lexer makes of a stretch of text. */
#ifndef SDL_TOKENS_H
#define SDL_TOKENS_H

#include "plug/shape_class.h"
#include "sdl/source.h"

/* What is known of a word beforehand. */
enum {
    TRAIT_BASE = 1u << 0,        /* of the base language: does not make a file `povray` */
    TRAIT_SHAPE = 1u << 1,       /* a primitive of the language, whether its plugin is there or not */
    TRAIT_LATER = 1u << 2,       /* of POV-Ray's language, for a feature that is not here yet */
    TRAIT_PAINT = 1u << 3,       /* a colour may begin with it */
    TRAIT_NAMED = 1u << 4        /* a message about the missing feature has been given */
};

/* Words that have a meaning here: identifier, text, flags. */
#define TOKEN_WORDS(X) \
    X(ADC_BAILOUT, "adc_bailout", TRAIT_BASE) \
    X(AMBIENT, "ambient", TRAIT_BASE) \
    X(AMBIENT_LIGHT, "ambient_light", TRAIT_BASE) \
    X(ANGLE, "angle", TRAIT_BASE) \
    X(ASSUMED_GAMMA, "assumed_gamma", 0) \
    X(BACKGROUND, "background", 0) \
    X(BLUE, "blue", TRAIT_BASE | TRAIT_PAINT) \
    X(BOX, "box", TRAIT_BASE | TRAIT_SHAPE) \
    X(CAMERA, "camera", TRAIT_BASE) \
    X(COLOR, "color", TRAIT_BASE | TRAIT_PAINT) \
    X(COLOUR, "colour", TRAIT_BASE | TRAIT_PAINT) \
    X(CONE, "cone", TRAIT_BASE | TRAIT_SHAPE) \
    X(CYLINDER, "cylinder", TRAIT_BASE | TRAIT_SHAPE) \
    X(DIFFUSE, "diffuse", TRAIT_BASE) \
    X(DIRECTION, "direction", 0) \
    X(FILTER, "filter", TRAIT_BASE | TRAIT_PAINT) \
    X(FINISH, "finish", TRAIT_BASE) \
    X(GLOBAL_SETTINGS, "global_settings", TRAIT_BASE) \
    X(GREEN, "green", TRAIT_BASE | TRAIT_PAINT) \
    X(HOLLOW, "hollow", 0) \
    X(INTERIOR, "interior", TRAIT_BASE) \
    X(INVERSE, "inverse", 0) \
    X(IOR, "ior", TRAIT_BASE) \
    X(LIGHT_SOURCE, "light_source", TRAIT_BASE) \
    X(LOCATION, "location", TRAIT_BASE) \
    X(LOOK_AT, "look_at", TRAIT_BASE) \
    X(MATRIX, "matrix", 0) \
    X(MAX_TRACE_LEVEL, "max_trace_level", TRAIT_BASE) \
    X(METALLIC, "metallic", TRAIT_BASE) \
    X(NO_SHADOW, "no_shadow", 0) \
    X(OPEN, "open", 0) \
    X(PHONG, "phong", TRAIT_BASE) \
    X(PHONG_SIZE, "phong_size", TRAIT_BASE) \
    X(PIGMENT, "pigment", TRAIT_BASE) \
    X(POLYGON, "polygon", TRAIT_BASE | TRAIT_SHAPE) \
    X(QUADRIC, "quadric", TRAIT_BASE | TRAIT_SHAPE) \
    X(RED, "red", TRAIT_BASE | TRAIT_PAINT) \
    X(REFLECTION, "reflection", TRAIT_BASE) \
    X(RGB, "rgb", TRAIT_BASE | TRAIT_PAINT) \
    X(RGBF, "rgbf", TRAIT_BASE | TRAIT_PAINT) \
    X(RGBFT, "rgbft", TRAIT_PAINT) \
    X(RGBT, "rgbt", TRAIT_PAINT) \
    X(RIGHT, "right", TRAIT_BASE) \
    X(ROTATE, "rotate", TRAIT_BASE) \
    X(SCALE, "scale", TRAIT_BASE) \
    X(SKY, "sky", 0) \
    X(SPHERE, "sphere", TRAIT_BASE | TRAIT_SHAPE) \
    X(TEXTURE, "texture", 0) \
    X(TRANSLATE, "translate", TRAIT_BASE) \
    X(TRANSMIT, "transmit", TRAIT_PAINT) \
    X(UP, "up", TRAIT_BASE) \
    X(VERSION, "version", 0)

#define TOKEN_IDENTIFIER(name, text, flags) WORD_##name,
typedef enum word_id { WORD_OTHER, TOKEN_WORDS(TOKEN_IDENTIFIER) WORD_COUNT } word_id;
#undef TOKEN_IDENTIFIER

typedef struct symbol {
    const char *name;            /* with an end mark */
    uint32_t length, hash;
    word_id id;                  /* WORD_OTHER: none of TOKEN_WORDS */
    uint32_t flags;              /* TRAIT_* above */
    const shape_class *shape;   /* NULL: not asked for yet, or none */
    void *last;                  /* what was written last of the shape; NULL: nothing yet */
} symbol;

/* A mark's kind is its character. */
enum { TOKEN_END = 0, TOKEN_NUMBER = 256, TOKEN_WORD, TOKEN_STRING, TOKEN_BAD };

typedef struct token {
    int kind;
    symbol *symbol;              /* of a word; NULL: never met */
    double number;
    const char *fault;           /* what is wrong: an error if the kind is BAD, else worth a warning */
    place at;
} token;

const char *token_word_name(word_id id);
uint32_t token_word_flags(word_id id);
/* The words with a meaning here, then those of features to come; NULL past the last. */
const char *token_word(size_t index, word_id *id, uint32_t *flags);

#endif
