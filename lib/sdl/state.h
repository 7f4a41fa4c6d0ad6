/* state.h - what reading a text needs to know, and the steps from token to token. */
#ifndef SDL_STATE_H
#define SDL_STATE_H

#include "model/model.h"
#include "plug/registry.h"
#include "sdl/intern.h"
#include "sdl/lex.h"
#include "sdl/reader.h"
#include "sdl/scope.h"
#include "sdl/token_buffer.h"
#include "sdl/value.h"

/* Braces that are open, innermost first; they live on the stack of the function that reads them. */
typedef struct block {
    place keyword, brace;
    struct block *outer;
} block;

/* A camera as written; which way it looks depends on the dialect, which the end of the text decides. */
typedef struct camera_parsed {
    place at;                    /* of its keyword; source NULL: there is none */
    place look_at_place;
    pov_vec3 location, look_at, direction, right, up, sky;
    double angle;                /* degrees; 0: none */
    bool has_look_at, has_angle, is_sized_by_distance;
    double angle_upwards, aperture, blur_samples;
    pov_vec3 focal_point;
    bool has_focal_point;
    bool has_size;               /* right or up was written */
    pov_camera_type type;
    double version;              /* at its end */
    place angle_place;
    const transform *map;
    const normal_node *normal;   /* or NULL */
    const struct camera_mesh *mesh;   /* of a mesh_camera */
    const pov_camera *given;     /* by a program, instead of all the rest; or NULL */
} camera_parsed;

typedef struct settings_parsed {
    bool has_ambient_light, has_noise_generator;
    double assumed_gamma;        /* 0: none */
    bool assumed_srgb;           /* it is that of sRGB, and only about assumed_gamma */
    double version;              /* 0: none was set */
} settings_parsed;

/* Words that a plugin asked for and that were not there: what the word that is there may have been meant as.
 * */
enum { TRIED_MAX = 4, TRIED_LENGTH = 24 };

/* ---- where tokens come from ---- */

typedef enum frame_kind { FRAME_SCENE, FRAME_INCLUDE, FRAME_MACRO, FRAME_LOOP } frame_kind;

typedef struct frame {
    frame_kind kind;
    source *text;                /* lexed as it is read; NULL: tokens are read */
    token_buffer *tokens;
    size_t at, end;              /* of the tokens: the next, and behind the last */
    size_t conditions;           /* how many were open when it began */
    const symbol *name;          /* of the macro */
    place call;                  /* what made it begin */
    bool has_saved;              /* a token was read too far, and comes first */
    token saved;
} frame;

typedef struct frame_list { frame *items; size_t count, capacity; } frame_list;

/* ---- #if, #switch, loops ---- */

typedef enum condition_kind { CONDITION_IF, CONDITION_SWITCH, CONDITION_WHILE, CONDITION_FOR } condition_kind;

typedef struct condition {
    condition_kind kind;
    bool has_else;               /* its #else has been seen */
    place at;                    /* of the directive */
    double value;                /* what #switch looks for */
    size_t frame, start;         /* of a loop: where its turns begin */
    int parentheses;             /* of expressions that are open around it */
    symbol *variable;            /* of #for */
    double last, step;
} condition;

typedef struct condition_list { condition *items; size_t count, capacity; } condition_list;

/* While a directive is read, what could stand behind its last value waits, unless it began in between: another
 * directive, a macro, the end of a macro's body. */
typedef struct hold {
    bool is_on;
    int nesting;
    size_t frames, conditions;
} hold;

/* Of a macro: a value, or what a name leads to, which the lender keeps. */
typedef struct argument { value value; value *slot; shared *lender; } argument;
typedef struct argument_list { argument *items; size_t count, capacity; } argument_list;

typedef struct random_stream { uint32_t state; } random_stream;
typedef struct random_list { random_stream *items; size_t count, capacity; } random_list;

enum { INCLUDE_PATH_MAX = 4096 };

/* Where equal materials are found: the number counts from 1, 0 is an empty slot. */
typedef struct material_slot { uint32_t hash, number; } material_slot;

struct pov_reader {
    model *model;
    registry *plugins;
    const reader_options *options;
    symbols words;
    source_list sources;
    token_buffer_list buffers;
    value_heap heap;
    arena members;               /* of groups and clips as parsed, until all has been read */
    frame_list frames;
    frame *top;                  /* the last of them */
    condition_list conditions;
    scope_list scopes;
    hold hold;
    int nesting;                 /* brackets of any kind that are open */
    int depth;                   /* calls of the reader's own functions within each other */
    bool wants_name;             /* a macro's name is not called */
    const symbol *declaring;     /* the name whose value is read; NULL: none */
    token token;                 /* the next one, not taken yet */
    place last;                  /* the one that was taken last; source NULL: none was */
    place object;                /* the word of the statement that is being read */
    place value;                 /* where the value that was read last begins */
    const char *wanted;          /* what messages say where no value is */
    block *block;
    bool failed;                 /* from here on every token is the end of the text */
    pov_error error, first_error;
    size_t plugin_braces;        /* that plugins have opened */
    bool has_faces;              /* the shape that a plugin reads: see value_vector_of_face() */
    token failed_at;             /* the next token when it failed, the braces open in front of it, */
    size_t failed_depth;
    bool failed_in_directive;    /* and whether a directive was being read */
    int error_count;             /* behind which reading went on */
    pov_dialect wanted_dialect;
    place povray_word;           /* the first word that makes the file `povray`; source NULL: none yet */
    double version;              /* what #version says now */
    camera_parsed camera;
    settings_parsed settings;
    struct surface_parsed *defaults;   /* of #default */
    const struct surface_parsed *placed;   /* those of the statement that is being read */
    struct surface_parsed *placing;        /* where these go when its block ends; NULL: they are there */
    const struct surface_parsed *shared_surface;   /* of the object that was kept last */
    random_list randoms;
    argument_list arguments;     /* of calls that are being read */
    struct written *written;     /* files that the scene wrote */
    struct image_file *images;   /* that the scene named */
    char own_includes[INCLUDE_PATH_MAX];   /* the folder of this library's include files; "": unknown */
    reader_limits limits;
    uint64_t turns;              /* of loops so far */
    size_t input, image_bytes;   /* bytes of files and of pixels so far */
    uint32_t until_told;         /* tokens of text until progress is told again */
    uint32_t light_groups;       /* so far */
    double started;              /* when reading began */
    int parentheses;             /* of expressions that are open */
    int macros;                  /* that were defined */
    intern_table interned;       /* parts of textures */
    material textured;           /* of the textures that were used last */
    material_slot *material_slots;   /* a hash table of the model's materials */
    size_t material_capacity;
    struct cutaway_list *cutaway;   /* of the object with cutaway_textures that is being added; NULL: there is none */
    struct array_rows *rows;     /* arrays that a shape is read from; NULL: it is read from text */
    struct copies_read *copies;  /* uses of declared solids, until all has been read; NULL: none waits */
    struct part_list *parts;     /* textures of the object that is read; NULL: none reads any */
    char tried[TRIED_MAX][TRIED_LENGTH];
    int tried_count;
};

/* Take the token and fetch the next. */
void state_advance(pov_reader *in);
/* A token has been fetched: what it alone tells is noted. */
void state_look(pov_reader *in);
/* Where a value must stand: what waits for the end of a directive does not wait any more. */
void state_settle(pov_reader *in);

static inline bool state_at_end(const pov_reader *in)
{
    return in->token.kind == TOKEN_END;
}

/* Take the punctuation if it is next. */
static inline bool state_accept(pov_reader *in, int punct)
{
    if (in->token.kind != punct)
        return false;
    state_advance(in);
    return true;
}

/* The keyword that is next, or KEYWORD_OTHER. */
static inline keyword_id state_keyword(const pov_reader *in)
{
    return in->token.symbol ? in->token.symbol->id : KEYWORD_OTHER;
}

bool state_accept_keyword(pov_reader *in, keyword_id keyword);
/* Take the punctuation or fail: `expected ">" after ...`. */
void state_expect(pov_reader *in, int punct);
/* The same for brackets, between which nothing waits. */
void state_open(pov_reader *in, int punct);
void state_close(pov_reader *in, int punct);
/* The punctuation must be next; it is not taken. */
bool state_require(pov_reader *in, int punct);
/* The place from the token on makes the file `povray`, unless one did before. */
void state_note_povray(pov_reader *in, const place *word);
/* Memory of the scene, zeroed. NULL: none, and the reader has failed. */
void *state_alloc(pov_reader *in, size_t bytes, size_t align);
/* One more level of the reader's own calls. False: too many, and the reader has failed. */
bool state_enter(pov_reader *in);
static inline void state_exit(pov_reader *in) { in->depth--; }

#endif
