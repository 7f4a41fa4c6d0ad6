#include "sdl/include.h"

#include "base/dl.h"
#include "base/file.h"
#include "base/str.h"
#include "sdl/directive.h"
#include "sdl/expression.h"
#include "sdl/frame.h"
#include "sdl/limit.h"
#include "sdl/report.h"
#include "sdl/text.h"
#include "sdl/text_file.h"

#include <string.h>

/* Where packages of POV-Ray put its include files. */
static const char *const installed[] = {
    "/usr/local/share/povray-3.7/include", "/usr/share/povray-3.7/include", "/usr/local/share/povray/include",
    "/usr/share/povray/include", "/opt/homebrew/share/povray-3.7/include",
};
enum { INSTALLED = sizeof installed / sizeof installed[0] };

/* ---- folders ---- */

typedef struct folder { const char *path; size_t length; } folder;

static folder folder_of(const char *file)
{
    const char *slash = strrchr(file, '/');
    folder f = { file, slash ? (size_t)(slash - file) : 0 };

    if (slash == file)
        f.length = 1;
    return f;
}

static const char *text_name(const pov_reader *in)
{
    return in->token.at.source ? in->token.at.source->name : "";
}

static const char *scene_name(const pov_reader *in)
{
    return in->frames.items[0].text->name;
}

void include_init(pov_reader *in)
{
    static const char below[] = "/../share/povtrace/include";
    const size_t size = sizeof in->own_includes;

    if (dl_own_folder(in->own_includes, size - sizeof below))
        strcat(in->own_includes, below);
    else
        in->own_includes[0] = '\0';
}

/* POV-Ray's own files, then those of this library. */
static bool installed_at(const pov_reader *in, int index, folder *out)
{
    if (index < INSTALLED)
        out->path = installed[index];
    else if (index == INSTALLED && in->own_includes[0])
        out->path = in->own_includes;
    else if (index <= INSTALLED + 1)
        out->path = POV_SHARE_DIR "/include";
    else
        return false;
    out->length = strlen(out->path);
    return true;
}

/* The index-th folder to look in. False: past the last. */
static bool folder_at(const pov_reader *in, int index, folder *out)
{
    const char *list = in->options && in->options->library_path ? in->options->library_path : "";
    int i;

    if (index < 3) {
        *out = folder_of(index == 0 ? scene_name(in) : index == 1 ? text_name(in) : "");
        return true;
    }
    for (i = 3; *list; i++) {
        out->path = list;
        out->length = strcspn(list, ":");
        if (i == index)
            return true;
        list += out->length + (list[out->length] == ':');
    }
    return installed_at(in, index - i, out);
}

static bool join(const folder *f, const char *name, const char *ending, char out[INCLUDE_PATH_MAX])
{
    const size_t length = strlen(name), more = strlen(ending);
    size_t n = 0;

    if (f->length + 1 + length + more >= INCLUDE_PATH_MAX)
        return false;
    if (f->length > 0 && name[0] != '/') {
        memcpy(out, f->path, f->length);
        out[f->length] = '/';
        n = f->length + 1;
    }
    memcpy(out + n, name, length);
    memcpy(out + n + length, ending, more + 1);
    return true;
}

/* ---- no way out of them ---- */

static bool is_below(const char *path, const folder *f)
{
    char root[INCLUDE_PATH_MAX], name[INCLUDE_PATH_MAX];
    size_t n;

    memcpy(name, f->path, f->length);
    name[f->length] = '\0';
    if (!file_resolve(f->length > 0 ? name : ".", root, sizeof root))
        return false;
    n = strlen(root);
    return strncmp(path, root, n) == 0 && (path[n] == '/' || root[n - 1] == '/');
}

/* With links and `..` resolved the file lies below one of the folders. */
static bool is_open_to_scenes(const pov_reader *in, const char *path)
{
    char real[INCLUDE_PATH_MAX];
    folder f;
    int i;

    if (!file_resolve(path, real, sizeof real))
        return false;
    for (i = 0; folder_at(in, i, &f); i++)
        if (i != 1 && is_below(real, &f))
            return true;
    return false;
}

/* A package may keep a file elsewhere, as fonts, and have a link to it among its include files. */
static bool is_packaged(const folder *f, const char *name)
{
    bool found = false;

    for (int i = 0; i < INSTALLED; i++)
        found |= strlen(installed[i]) == f->length && memcmp(installed[i], f->path, f->length) == 0;
    return found && !strchr(name, '/');
}

static const char *const included[] = { "", ".inc", ".INC", NULL };

bool include_find(pov_reader *in, const string *name, char path[INCLUDE_PATH_MAX])
{
    return include_find_with(in, name, included, path);
}

bool include_find_with(pov_reader *in, const string *name, const char *const *endings, char path[INCLUDE_PATH_MAX])
{
    folder f;
    int i, e;

    if (name->length == 0 || strlen(name->text) != name->length)
        return false;
    for (e = 0; endings[e]; e++)
        for (i = 0; folder_at(in, i, &f); i++)
            if (join(&f, name->text, endings[e], path) && file_exists(path) &&
                (is_packaged(&f, name->text) || is_open_to_scenes(in, path)))
                return true;
    return false;
}

static bool has_installed(void)
{
    int i;

    for (i = 0; i < INSTALLED; i++)
        if (file_exists(installed[i]))
            return true;
    return false;
}

void include_not_found(pov_reader *in, const string *name, const char *const *endings)
{
    char path[INCLUDE_PATH_MAX];
    bool is_outside = false;
    folder f;

    for (int e = 0; endings[e]; e++)
        for (int i = 0; folder_at(in, i, &f) && !is_outside; i++)
            is_outside = join(&f, name->text, endings[e], path) && file_exists(path);
    if (is_outside)
        report_fail(in, &in->value, POV_E_IO, "\"%.200s\" is outside of the folders that scenes are read from; "
                    "-L FOLDER, or +LFOLDER as povray, adds one", name->text);
    else
        report_fail(in, &in->value, POV_E_IO, "there is no file \"%.200s\" in the folders that scenes are read from%s",
                    name->text, has_installed() ? "" : "; POV-Ray's own come with the package povray-includes");
}

bool include_exists(pov_reader *in, const string *name)
{
    static const char *const as_it_is[] = { "", NULL };
    char path[INCLUDE_PATH_MAX];

    return text_file_kept(in, name) > 0 || include_find_with(in, name, as_it_is, path);
}

/* ---- texts ---- */

static source *add_text(pov_reader *in, char *text, size_t length, const char *name)
{
    char *owned = env_resize(in->model->env, text, length + strlen(name) + 2, 1);
    source *s;

    if (!owned) {
        env_free(in->model->env, text);
        report_memory(in);
        return NULL;
    }
    strcpy(owned + length + 1, name);
    s = source_add(&in->sources, owned, length, owned + length + 1);
    if (!s) {
        env_free(in->model->env, owned);
        report_memory(in);
        return NULL;
    }
    s->owned = owned;
    return s;
}

/* Files that are included often and equal what they were are read as tokens, but for very large ones. Few times are those of files
 * that guard themselves: their text is skipped sooner than it becomes tokens. */
enum { REPLAYED_MAX = 1 << 22, READ_AGAIN_MAX = 4 };

static source *find_same(const pov_reader *in, const char *text, size_t length, const char *name)
{
    source *s;

    for (s = in->sources.all; s; s = s->older)
        if (s->owned && (size_t)(s->end - s->owned) == length && strcmp(s->name, name) == 0 &&
            memcmp(s->owned, text, length) == 0)
            return s;
    return NULL;
}

/* The same text, to be read from its beginning. */
static source *begin_again(pov_reader *in, const source *s)
{
    source *fresh = source_add(&in->sources, s->owned, (size_t)(s->end - s->owned), s->name);

    if (!fresh)
        report_memory(in);
    return fresh;
}

static token_buffer *lex_whole(pov_reader *in, const source *s)
{
    token_buffer *b = token_buffer_create(&in->buffers);
    source *fresh = b ? begin_again(in, s) : NULL;
    token t;

    while (fresh && !in->failed) {
        lex_next(&in->words, fresh, &t);
        if (t.kind == TOKEN_END)
            return b;
        if (!token_buffer_add(&in->buffers, b, &t))
            break;
    }
    report_memory(in);
    if (b)
        token_buffer_release(&in->buffers, b);
    return NULL;
}

/* ---- #include ---- */

static frame *push_again(pov_reader *in, source *s)
{
    if (s->end - s->owned > REPLAYED_MAX || s->again < READ_AGAIN_MAX) {
        source *fresh = begin_again(in, s);

        s->again++;
        return fresh ? frame_push_text(in, FRAME_INCLUDE, fresh) : NULL;
    }
    if (!s->tokens)
        s->tokens = lex_whole(in, s);
    return s->tokens ? frame_push_tokens(in, FRAME_INCLUDE, s->tokens, 0, s->tokens->count) : NULL;
}

/* The text becomes the reader's. */
static frame *push_text(pov_reader *in, char *text, size_t length, const char *name)
{
    source *same = find_same(in, text, length, name), *s;

    if (same) {
        env_free(in->model->env, text);
        return push_again(in, same);
    }
    s = add_text(in, text, length, name);
    return s ? frame_push_text(in, FRAME_INCLUDE, s) : NULL;
}

/* What the scene wrote itself counts before what is on the disk. */
static char *read_text(pov_reader *in, const string *name, char path[INCLUDE_PATH_MAX], size_t *length)
{
    char *text = text_file_copy(in, name, length);
    pov_error error;

    if (text || in->failed) {
        join(&(folder){ "", 0 }, name->text, "", path);
    } else if (!include_find(in, name, path)) {
        include_not_found(in, name, included);
    } else if (limit_read_file(in, path, &text, length, &error) < 0) {
        report_pass_on(in, &in->value, &error);
        text = NULL;
    }
    return text;
}

static void begin(pov_reader *in, const string *name, const place *at, bool is_literal)
{
    char path[INCLUDE_PATH_MAX] = "", *text;
    size_t length = 0;

    if (in->scopes.count > in->limits.depth)
        report_fail(in, at, POV_E_SYNTAX, "more than %zu macros and include files within each other",
                    in->limits.depth);
    text = in->failed ? NULL : read_text(in, name, path, &length);
    if (!text)
        return;
    if (!is_literal)
        frame_save(in);
    if (!scope_push(in))
        env_free(in->model->env, text);
    else if (push_text(in, text, length, path))
        in->top->call = *at;
}

void include_run(pov_reader *in, const place *at)
{
    bool is_literal;
    string *name;

    directive_step(in);
    state_settle(in);
    in->value = in->token.at;
    is_literal = in->token.kind == TOKEN_STRING;
    name = expression_to_string(in, is_literal ? text_raw(in) : expression_read(in));
    if (!name)
        return;
    begin(in, name, at, is_literal);
    value_unshare(&in->heap, &name->head);
    directive_step(in);
}
