#include "sdl/text_file.h"

#include "base/file.h"
#include "sdl/array.h"
#include "sdl/binary.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/include.h"
#include "sdl/limit.h"
#include "sdl/report.h"
#include "sdl/text.h"

#include <string.h>

/* A file that the scene wrote. */
typedef struct written {
    struct written *next;
    char *bytes;
    size_t count, capacity;
    uint32_t times;              /* that it was opened or closed */
    bool is_open;
    char name[];
} written;

typedef struct text_file {
    shared head;
    source *text;                /* read; NULL: written */
    written *out;
} text_file;

/* ---- what was written ---- */

static written *find(const pov_reader *in, const char *name)
{
    written *w;

    for (w = in->written; w; w = w->next)
        if (strcmp(w->name, name) == 0)
            return w;
    return NULL;
}

uint32_t text_file_kept(const pov_reader *in, const string *name)
{
    const written *w = find(in, name->text);

    return w ? w->times : 0;
}

char *text_file_copy(pov_reader *in, const string *name, size_t *length)
{
    const written *w = find(in, name->text);
    char *copy;

    if (!w)
        return NULL;
    copy = env_alloc(in->model->env, w->count + 1, 1);
    if (!copy) {
        report_memory(in);
        return NULL;
    }
    if (w->count > 0)
        memcpy(copy, w->bytes, w->count);
    *length = w->count;
    return copy;
}

static bool put(pov_reader *in, written *w, const char *bytes, size_t count)
{
    if (w->capacity - w->count < count) {
        size_t capacity = 2 * w->capacity + count + 64;
        char *longer = env_resize(in->model->env, w->bytes, capacity, 1);

        if (!longer) {
            report_memory(in);
            return false;
        }
        w->bytes = longer;
        w->capacity = capacity;
    }
    memcpy(w->bytes + w->count, bytes, count);
    w->count += count;
    return true;
}

static written *create(pov_reader *in, const string *name)
{
    written *w = env_alloc(in->model->env, 1, sizeof *w + name->length + 1);

    if (!w) {
        report_memory(in);
        return NULL;
    }
    memcpy(w->name, name->text, name->length);
    w->next = in->written;
    in->written = w;
    return w;
}

/* Does the scene write where that was allowed? The file itself may be new. */
static bool is_allowed(const pov_reader *in, const char *name)
{
    const char *root = in->options ? in->options->write_path : NULL, *slash = strrchr(name, '/');
    char folder[INCLUDE_PATH_MAX], real[INCLUDE_PATH_MAX], allowed[INCLUDE_PATH_MAX];
    size_t n = slash ? (size_t)(slash - name) : 0;

    if (!root || n >= sizeof folder)
        return false;
    memcpy(folder, name, n);
    folder[n] = '\0';
    if (!file_resolve(slash == name ? "/" : n > 0 ? folder : ".", real, sizeof real) ||
        !file_resolve(root, allowed, sizeof allowed))
        return false;
    n = strlen(allowed);
    return strncmp(real, allowed, n) == 0 && (real[n] == '\0' || real[n] == '/' || allowed[n - 1] == '/') &&
           !file_is_link(name);
}

static void store(pov_reader *in, written *w)
{
    file_writer *writer;
    pov_error error;

    w->is_open = false;
    w->times++;
    if (!is_allowed(in, w->name)) {
        report_warn(in, &in->last, "\"%s\" is kept for this scene alone: writing files was not allowed", w->name);
        return;
    }
    writer = env_alloc(in->model->env, 1, sizeof *writer);
    if (!writer) {
        report_memory(in);
        return;
    }
    if (file_writer_open(writer, in->model->env, w->name, &error) < 0) {
        report_pass_on(in, &in->last, &error);
    } else {
        file_writer_put(writer, w->bytes, w->count);
        if (file_writer_commit(writer, &error) < 0)
            report_pass_on(in, &in->last, &error);
    }
    env_free(in->model->env, writer);
}

void text_file_store_open(pov_reader *in)
{
    for (written *w = in->written; w && !in->failed; w = w->next)
        if (w->is_open)
            store(in, w);
}

void text_file_free_all(pov_reader *in)
{
    while (in->written) {
        written *w = in->written;

        in->written = w->next;
        env_free(in->model->env, w->bytes);
        env_free(in->model->env, w);
    }
}

/* ---- opening and closing ---- */

static source *open_to_read(pov_reader *in, const string *name)
{
    char path[INCLUDE_PATH_MAX], *bytes, *kept;
    size_t length;
    pov_error error;
    source *s;

    bytes = text_file_copy(in, name, &length);
    if (!bytes && !in->failed) {
        if (!include_find(in, name, path))
            report_fail(in, &in->value, POV_E_IO, "there is no file \"%s\"", name->text);
        else if (limit_read_file(in, path, &bytes, &length, &error) < 0)
            report_pass_on(in, &in->value, &error);
    }
    if (in->failed)
        return NULL;
    kept = state_alloc(in, name->length + 1, 1);
    if (kept)
        memcpy(kept, name->text, name->length + 1);
    s = kept ? source_add(&in->sources, bytes, length, kept) : NULL;
    if (s) {
        s->owned = bytes;
        return s;
    }
    env_free(in->model->env, bytes);
    report_memory(in);
    return NULL;
}

/* What is appended to stands before it, on the disk or in the reader. */
static written *open_to_write(pov_reader *in, const string *name, bool appends)
{
    written *w = find(in, name->text);
    char path[INCLUDE_PATH_MAX], *bytes;
    size_t length;
    pov_error error;
    bool has_begun;

    if (w && !appends)
        w->count = 0;
    has_begun = w != NULL;
    if (!w)
        w = create(in, name);
    if (!w)
        return NULL;
    w->is_open = true;
    w->times++;
    if (has_begun || !appends || !include_find(in, name, path))
        return w;
    if (limit_read_file(in, path, &bytes, &length, &error) < 0) {
        report_pass_on(in, &in->value, &error);
        return w;
    }
    put(in, w, bytes, length);
    env_free(in->model->env, bytes);
    return w;
}

static text_file *make(pov_reader *in, const string *name)
{
    const char *mode = in->token.kind == TOKEN_WORD ? in->token.symbol->name : "";
    text_file *f = in->failed ? NULL : value_share(&in->heap, VALUE_FILE, sizeof *f);

    if (!f) {
        report_memory(in);
        return NULL;
    }
    if (strcmp(mode, "read") == 0)
        f->text = open_to_read(in, name);
    else if (strcmp(mode, "write") == 0 || strcmp(mode, "append") == 0)
        f->out = open_to_write(in, name, mode[0] == 'a');
    else
        report_expected(in, "\"read\", \"write\" or \"append\"");
    return f;
}

void text_file_open(pov_reader *in, const place *at)
{
    symbol *name;
    string *path;
    value v = value_of_number(0.0);
    text_file *f;

    (void)at;
    in->wants_name = true;
    state_advance(in);
    in->wants_name = false;
    name = in->token.symbol;
    if (in->token.kind != TOKEN_WORD || name->id != KEYWORD_OTHER)
        report_expected(in, "a name for the file");
    else if (name->binding)
        report_fail(in, &in->token.at, POV_E_SYNTAX, "\"%s\" is %s already", name->name, value_name(scope_value(name)));
    state_advance(in);
    state_settle(in);
    in->value = in->token.at;
    if (in->token.kind == TOKEN_STRING) {
        v = text_raw(in);
        state_advance(in);
    } else {
        v = expression_read(in);
    }
    path = expression_to_string(in, v);
    f = path ? make(in, path) : NULL;
    if (path)
        value_unshare(&in->heap, &path->head);
    if (!f)
        return;
    v.kind = VALUE_FILE;
    v.as.shared = &f->head;
    scope_declare(in, name, v);
    state_advance(in);
}

static void forget(pov_reader *in, symbol *name, text_file *f)
{
    if (f->out)
        store(in, f->out);
    scope_forget(in, name);
}

void text_file_close(pov_reader *in, const place *at)
{
    const value *v;
    symbol *name;

    (void)at;
    in->wants_name = true;
    state_advance(in);
    in->wants_name = false;
    name = in->token.symbol;
    v = name ? scope_value(name) : NULL;
    if (v && v->kind == VALUE_FILE)
        forget(in, name, (text_file *)v->as.shared);
    state_advance(in);
    state_accept(in, ';');
}

/* The file that is named in `( NAME`. NULL: the reader has failed. */
static symbol *read_name(pov_reader *in, text_file **f)
{
    symbol *name;

    in->wants_name = true;
    state_advance(in);
    state_open(in, '(');
    in->wants_name = false;
    name = in->token.symbol;
    if (!name || !name->binding || name->binding->slot->kind != VALUE_FILE) {
        report_expected(in, "the name of an open file");
        return NULL;
    }
    *f = (text_file *)name->binding->slot->as.shared;
    (*f)->head.uses++;           /* what stands between the brackets may close it */
    state_advance(in);
    return in->failed ? NULL : name;
}

static void let_go(pov_reader *in, text_file *f)
{
    if (f)
        value_unshare(&in->heap, &f->head);
}

/* ---- writing ---- */

static void write_vector(pov_reader *in, written *w, const value *v)
{
    char buffer[160];
    size_t n = 0;
    int i;

    for (i = 0; i < v->size; i++) {
        buffer[n++] = i == 0 ? '<' : ',';
        n += (size_t)text_general(buffer + n, sizeof buffer - n, v->as.v[i]);
    }
    buffer[n++] = '>';
    buffer[n++] = ' ';
    put(in, w, buffer, n);
}

static void write_item(pov_reader *in, written *w)
{
    value v;
    char buffer[40];

    in->wanted = "a number, a vector or a string";
    v = expression_read(in);
    if (v.kind == VALUE_NUMBER)
        put(in, w, buffer, (size_t)text_general(buffer, sizeof buffer, v.as.v[0]));
    else if (v.kind == VALUE_STRING)
        put(in, w, value_string(&v)->text, value_string(&v)->length);
    else if (v.kind == VALUE_VECTOR && !v.is_colour)
        write_vector(in, w, &v);
    else
        report_fail(in, &in->value, POV_E_SYNTAX, "expected a number, a vector or a string, found %s", value_name(&v));
    value_drop(&in->heap, &v);
}

/* Behind the word of a format: numbers and vectors up to a comma. */
static void write_binary(pov_reader *in, written *w, const binary_format *f)
{
    char bytes[4];
    value v;
    int i;

    state_advance(in);
    state_accept(in, ',');
    do {
        in->wanted = "a number or a vector";
        v = expression_read(in);
        if (!value_is_arithmetic(&v) || v.is_colour)
            report_fail(in, &in->value, POV_E_SYNTAX, "expected a number or a vector, found %s", value_name(&v));
        for (i = 0; i < v.size && !in->failed; i++)
            put(in, w, bytes, binary_put(f, v.as.v[i], bytes));
        if (value_is_shared(&v))
            value_drop(&in->heap, &v);
    } while (!in->failed && in->token.kind != ',' && in->token.kind != ')');
}

static const binary_format *format_follows(pov_reader *in)
{
    state_settle(in);
    return in->token.kind == TOKEN_WORD ? binary_find(in->token.symbol->name) : NULL;
}

void text_file_write(pov_reader *in, const place *at)
{
    const binary_format *format;

    text_file *f = NULL;

    if (read_name(in, &f) && !f->out)
        report_fail(in, at, POV_E_SYNTAX, "the file is open for reading");
    state_accept(in, ',');
    while (!in->failed && in->token.kind != ')') {
        format = format_follows(in);
        if (format)
            write_binary(in, f->out, format);
        else
            write_item(in, f->out);
        state_accept(in, ',');
    }
    state_close(in, ')');
    let_go(in, f);
}

/* ---- reading ---- */

static bool read_sign(pov_reader *in, source *s, token *t)
{
    const bool is_negative = t->kind == '-';

    if (is_negative || t->kind == '+')
        lex_next(&in->words, s, t);
    return is_negative;
}

static double read_literal_number(pov_reader *in, source *s, token *t)
{
    bool is_negative = read_sign(in, s, t);

    if (t->kind != TOKEN_NUMBER) {
        report_fail(in, &t->at, POV_E_SYNTAX, "expected a number in the file");
        return 0.0;
    }
    return is_negative ? -t->number : t->number;
}

static value read_literal_vector(pov_reader *in, source *s, token *t)
{
    value v = value_of_number(0.0);

    v.kind = VALUE_VECTOR;
    v.size = 0;
    while (v.size < 5 && !in->failed) {
        lex_next(&in->words, s, t);
        v.as.v[v.size++] = read_literal_number(in, s, t);
        lex_next(&in->words, s, t);
        if (t->kind != ',')
            break;
    }
    if (!in->failed && t->kind != '>')
        report_fail(in, &t->at, POV_E_SYNTAX, "expected \">\" in the file");
    return v;
}

static value read_literal(pov_reader *in, source *s, token *t)
{
    token own = in->token;
    value v;

    if (t->kind == '<')
        return read_literal_vector(in, s, t);
    if (t->kind != TOKEN_STRING)
        return value_of_number(read_literal_number(in, s, t));
    in->token = *t;
    v = text_literal(in);
    if (!in->failed)
        in->token = own;
    return v;
}

/* The name that takes it, which may be an element of an array. */
static void take(pov_reader *in, symbol *name, value v)
{
    value *slot;
    shared *lender;

    state_advance(in);
    if (!name->binding || in->token.kind != '[') {
        scope_declare(in, name, v);
        return;
    }
    slot = name->binding->slot;
    lender = name->binding->lender ? name->binding->lender : &name->binding->head;
    lender->uses++;
    slot = expression_element(in, slot, &lender);
    if (slot && slot->kind == VALUE_NOTHING)
        report_fail(in, &in->last, POV_E_SYNTAX, "an element that is read into must have a value");
    if (slot && lender->kind == VALUE_ARRAY)
        array_set(in, (array *)lender, slot, v);
    else
        value_drop(&in->heap, &v);
    value_unshare(&in->heap, lender);
}

/* Does the name still lead to the file? */
static bool is_open(const symbol *name, const text_file *f)
{
    const value *v = scope_value(name);

    return v && v->kind == VALUE_FILE && v->as.shared == &f->head;
}

/* False: the file is over. One token behind each literal goes with it. */
static bool read_item(pov_reader *in, source *s)
{
    symbol *name = in->token.symbol;
    token t;

    if (in->token.kind != TOKEN_WORD || name->id != KEYWORD_OTHER) {
        report_expected(in, "a name");
        return false;
    }
    lex_next(&in->words, s, &t);
    if (t.kind == TOKEN_END)
        return false;
    take(in, name, read_literal(in, s, &t));
    lex_next(&in->words, s, &t);
    return t.kind != TOKEN_END;
}

void text_file_read(pov_reader *in, const place *at)
{
    text_file *f = NULL;
    symbol *name = read_name(in, &f);
    bool goes_on = true;

    if (name && !f->text)
        report_fail(in, at, POV_E_SYNTAX, "the file is open for writing");
    for (state_accept(in, ','); !in->failed && goes_on && in->token.kind != ')'; state_accept(in, ','))
        goes_on = read_item(in, f->text);
    while (!in->failed && !goes_on && in->token.kind != ')' && !state_at_end(in))
        state_advance(in);
    if (!in->failed && !goes_on && is_open(name, f))
        scope_forget(in, name);
    state_close(in, ')');
    let_go(in, f);
}
