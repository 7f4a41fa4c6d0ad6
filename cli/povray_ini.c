/* The words of POV-Ray's command line, and its INI files. */
#include "povray_read.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* INI files within each other. */
enum { DEEPEST = 16 };

/* ---- words ---- */

static bool ends_with(const char *text, const char *ending)
{
    const size_t n = strlen(text), m = strlen(ending);

    return n > m && strcasecmp(text + n - m, ending) == 0;
}

/* NAME.ini[SECTION]: cut in two in the copy. */
static char *cut_section(char *word)
{
    char *open = strrchr(word, '['), *close = open ? strchr(open, ']') : NULL;

    if (!close || close[1] != '\0')
        return NULL;
    *open = *close = '\0';
    return open + 1;
}

static bool is_setting(const char *word)
{
    const char *equals = strchr(word, '=');

    if (!equals || equals == word)
        return false;
    for (; word < equals; word++)
        if (!isalnum((unsigned char)*word) && *word != '_')
            return false;
    return true;
}

static bool read_setting(povray *p, const char *word)
{
    const char *equals = strchr(word, '=');
    char name[64];

    if (snprintf(name, sizeof name, "%.*s", (int)(equals - word), word) >= (int)sizeof name)
        return povray_add(p, "a setting", word, &p->ignored);
    return povray_set(p, name, equals + 1);
}

/* The file itself, or one with this ending behind it, in the working folder or else in those of Library_Path that were named
 * before. An absolute path stays what it is. */
static bool find(const povray *p, const char *name, const char *ending, char *out, size_t size)
{
    for (int i = -1; i < p->library.count; i++)
        for (int longer = 0; longer < 2; longer++) {
            const char *folder = i < 0 ? "" : p->library.item[i];

            if ((i < 0 || (name[0] != '/' && folder[0])) &&
                (size_t)snprintf(out, size, "%s%s%s%s", folder, i < 0 ? "" : "/", name, longer ? ending : "") < size &&
                access(out, F_OK) == 0)
                return true;
        }
    return false;
}

/* A word without an ending is an INI file where there is one of that name. */
static bool names_ini(const povray *p, const char *word)
{
    const char *slash = strrchr(word, '/');
    char path[POVRAY_TEXT + 4], longer[POVRAY_TEXT + 4];

    if (ends_with(word, ".ini"))
        return true;
    if (strchr(slash ? slash : word, '.') || word[0] == '-' || access(word, F_OK) == 0)
        return false;
    return (size_t)snprintf(longer, sizeof longer, "%s.ini", word) < sizeof longer && find(p, longer, "", path, sizeof path);
}

/* A word of the command line, or of a line of switches in an INI file. */
static bool read_word(povray *p, const char *word)
{
    char copy[POVRAY_TEXT];

    if ((word[0] == '+' || word[0] == '-') && word[1] != '\0')
        return povray_read_switch(p, word);
    if (is_setting(word))
        return read_setting(p, word);
    if (!povray_read_text(p, "a word of the command line", word, copy, sizeof copy))
        return false;
    if (cut_section(copy) || names_ini(p, copy))
        return povray_read_ini(p, word);
    return povray_read_text(p, "the input file", word, p->input, sizeof p->input);
}

/* ---- lines ---- */

static char *trim(char *text)
{
    size_t n;

    text += strspn(text, " \t\r\n");
    n = strlen(text);
    while (n > 0 && strchr(" \t\r\n", text[n - 1]))
        text[--n] = '\0';
    return text;
}

/* Without the quotation marks around it. */
static char *unquote(char *text)
{
    const size_t n = strlen(text);

    if (n >= 2 && (text[0] == '"' || text[0] == '\'') && text[n - 1] == text[0]) {
        text[n - 1] = '\0';
        text++;
    }
    return text;
}

/* A comment begins with ";" or "#" outside of quotation marks. */
static void cut_comment(char *line)
{
    char quote = '\0';

    for (; *line; line++) {
        if (quote ? *line == quote : *line == '"' || *line == '\'')
            quote = quote ? '\0' : *line;
        else if ((*line == ';' || *line == '#') && !quote) {
            *line = '\0';
            return;
        }
    }
}

/* The next word, without its quotation marks, wherever they stand in it: +I"my scene.pov". NULL: there is none. */
static char *next_word(char **rest)
{
    char *from = *rest + strspn(*rest, " \t"), *word = from, *to = from, quote = '\0';

    if (!*from)
        return NULL;
    for (; *from && (quote || !strchr(" \t", *from)); from++) {
        if (quote ? *from == quote : *from == '"' || *from == '\'')
            quote = quote ? '\0' : *from;
        else
            *to++ = *from;
    }
    *rest = from + (*from != '\0');
    *to = '\0';
    return word;
}

static bool read_words(povray *p, char *line)
{
    char *word;

    while ((word = next_word(&line)) != NULL)
        if (!read_word(p, word))
            return false;
    return true;
}

static bool read_line(povray *p, char *line)
{
    char *equals = strchr(line, '='), *name;
    char word[2 * POVRAY_TEXT];

    if (!equals || line[0] == '+' || line[0] == '-')
        return read_words(p, line);
    *equals = '\0';
    name = trim(line);
    snprintf(word, sizeof word, "%s=%s", name, unquote(trim(equals + 1)));
    if (!is_setting(word))
        return povray_refuse(p, "\"%s\" is no setting", name);
    return read_setting(p, word);
}

/* ---- files ---- */

/* Settings before the first [SECTION] always count, those behind it only where the section is asked for. */
static bool read_lines(povray *p, FILE *in, const char *path, const char *section)
{
    char buffer[2 * POVRAY_TEXT];
    bool counts = true;
    int number = 0;

    while (!p->problem[0] && fgets(buffer, sizeof buffer, in)) {
        char *line = buffer;

        number++;
        cut_comment(line);
        line = trim(line);
        if (line[0] == '[') {
            char *name = line + 1;

            name[strcspn(name, "]")] = '\0';
            counts = section && strcasecmp(name, section) == 0;
        } else if (counts && line[0] && !read_line(p, line)) {
            char why[POVRAY_TEXT];

            snprintf(why, sizeof why, "%s", p->problem);
            snprintf(p->problem, sizeof p->problem, "%.200s:%d: %.700s", path, number, why);
        }
    }
    return !p->problem[0];
}

bool povray_read_ini(povray *p, const char *name)
{
    char copy[POVRAY_TEXT], path[2 * POVRAY_TEXT + 8], *section;
    FILE *in = NULL;
    bool read;

    if (!povray_read_text(p, "the name of an INI file", name, copy, sizeof copy))
        return false;
    section = cut_section(copy);
    if (find(p, copy, ".ini", path, sizeof path))
        in = fopen(path, "r");
    if (!in)
        return povray_refuse(p, "cannot read the INI file \"%s\"", copy);
    if (p->ini_depth < DEEPEST) {
        p->ini_depth++;
        read = read_lines(p, in, path, section);
        p->ini_depth--;
    } else {
        read = povray_refuse(p, "INI files that include each other more than %d times", DEEPEST);
    }
    fclose(in);
    return read;
}

/* ---- the command line ---- */

bool povray_is_asked(int argc, char *const *argv)
{
    const char *name = argc > 0 && argv[0] ? argv[0] : "", *slash = strrchr(name, '/');

    if (strcmp(slash ? slash + 1 : name, "povray") == 0)
        return true;
    for (int i = 1; i < argc; i++)
        if (argv[i][0] == '+')
            return true;
    return argc > 1 && (ends_with(argv[1], ".ini") || strstr(argv[1], ".ini["));
}

/* The first of these that is there counts alone: what POVINI names, povray.ini in the working folder, the user's. */
static bool read_defaults(povray *p)
{
    const char *named = getenv("POVINI"), *home = getenv("HOME");
    char users[POVRAY_TEXT + 32] = "";
    const char *const paths[] = { named ? named : "", "povray.ini", users };

    if (home)
        snprintf(users, sizeof users, "%.*s/.povray/3.7/povray.ini", POVRAY_TEXT, home);
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        FILE *in = paths[i][0] ? fopen(paths[i], "r") : NULL;

        if (in) {
            read_lines(p, in, paths[i], NULL);
            fclose(in);
            break;
        }
        if (i == 0 && paths[0][0])
            povray_doubt(p, "cannot read \"%.500s\", which POVINI names", named);
    }
    return !p->problem[0];
}

/* The ending may be left out. */
static bool find_input(povray *p)
{
    char path[2 * POVRAY_TEXT + 8];

    if (!p->input[0] || strcmp(p->input, "-") == 0 || !find(p, p->input, ".pov", path, sizeof path))
        return true;
    return povray_read_text(p, "the input file", path, p->found, sizeof p->found);
}

bool povray_parse(povray *p, int argc, char *const *argv)
{
    memset(p, 0, sizeof *p);
    p->width = 800;
    p->height = 600;
    p->verbose = true;
    p->type = 'N';
    p->output_to_file = true;
    p->threshold = 0.3;
    p->depth = 3;
    p->quality = 9;
    p->last_clock = 1.0;
    p->frame_step = 1;
    p->first_frame = p->last_frame = POVRAY_NO_FRAME;
    if (!read_defaults(p))
        return false;
    for (int i = 1; i < argc; i++)
        if (!read_word(p, argv[i]))
            return false;
    if (!find_input(p))
        return false;
    if (!p->input[0])
        return povray_refuse(p, "no scene is named: +ISCENE.pov, or SCENE.pov");
    if (p->width < 1 || p->height < 1 || p->width > 1000000 || p->height > 1000000)
        return povray_refuse(p, "a picture of %d x %d pixels cannot be drawn", p->width, p->height);
    return true;
}
