#include "povray.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* ---- what is wrong ---- */

static bool refuse(povray *p, const char *format, ...) POV_PRINTF(2, 3);

static bool refuse(povray *p, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    if (!p->problem[0])
        vsnprintf(p->problem, sizeof p->problem, format, list);
    va_end(list);
    return false;
}

/* ---- values ---- */

static bool is_on(const char *text)
{
    static const char *const words[] = { "on", "true", "yes", "1" };

    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcasecmp(text, words[i]) == 0)
            return true;
    return false;
}

static bool is_off(const char *text)
{
    static const char *const words[] = { "off", "false", "no", "0" };

    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcasecmp(text, words[i]) == 0)
            return true;
    return false;
}

static bool read_bool(povray *p, const char *name, const char *text, bool *out)
{
    if (!is_on(text) && !is_off(text))
        return refuse(p, "%s is on or off, not \"%s\"", name, text);
    *out = is_on(text);
    return true;
}

static bool read_real(povray *p, const char *name, const char *text, double *out)
{
    char *end;

    *out = strtod(text, &end);
    return (end != text && *end == '\0') || refuse(p, "%s must be a number, not \"%s\"", name, text);
}

/* Programs write fractions, too: they are cut off, as POV-Ray does. */
static bool read_whole(povray *p, const char *name, const char *text, int *out)
{
    char *end;
    const double value = strtod(text, &end);

    if (end == text || *end != '\0' || !(value >= -1e9 && value <= 1e9))
        return refuse(p, "%s must be a whole number, not \"%s\"", name, text);
    *out = (int)value;
    return true;
}

static bool read_text(povray *p, const char *name, const char *text, char *out, size_t size)
{
    if (strlen(text) >= size)
        return refuse(p, "the value of %s is too long", name);
    strcpy(out, text);
    return true;
}

static bool add(povray *p, const char *name, const char *text, povray_list *to)
{
    if (to->count == POVRAY_LIST)
        return refuse(p, "%s is given more than %d times", name, POVRAY_LIST);
    return read_text(p, name, text, to->item[to->count++], POVRAY_TEXT);
}

/* ---- settings ---- */

static bool read_ini(povray *p, const char *path, const char *section);

/* Use of a setting in povc: a value of some kind; no effect (its request is met anyway, or concerns POV-Ray's own
 * window, consoles and bounding only); or unsupported, with a message. */
typedef enum kind { WHOLE, REAL, BOOL, TEXT, SHORT, LIST, FREE, ALIEN, SPECIAL } kind;

typedef struct setting { const char *name; kind kind; size_t at; } setting;

#define AT(member) offsetof(povray, member)
static const setting settings[] = {
    { "Width", WHOLE, AT(width) },
    { "Height", WHOLE, AT(height) },
    { "Input_File_Name", TEXT, AT(input) },
    { "Output_File_Name", TEXT, AT(output) },
    { "Output_To_File", BOOL, AT(output_to_file) },
    { "Output_File_Type", SPECIAL, 0 },
    { "Output_Alpha", BOOL, AT(alpha) },
    { "Bits_Per_Color", WHOLE, AT(bits) },
    { "File_Gamma", TEXT, AT(gamma) },
    { "Antialias", BOOL, AT(antialias) },
    { "Antialias_Threshold", REAL, AT(threshold) },
    { "Antialias_Depth", WHOLE, AT(depth) },
    { "Sampling_Method", WHOLE, AT(method) },
    { "Quality", WHOLE, AT(quality) },
    { "Work_Threads", WHOLE, AT(threads) },
    { "Stochastic_Seed", WHOLE, AT(seed) },
    { "Start_Column", REAL, AT(start_column) },
    { "End_Column", REAL, AT(end_column) },
    { "Start_Row", REAL, AT(start_row) },
    { "End_Row", REAL, AT(end_row) },
    { "Clock", SPECIAL, 0 },
    { "Initial_Clock", REAL, AT(first_clock) },
    { "Final_Clock", REAL, AT(last_clock) },
    { "Initial_Frame", WHOLE, AT(first_frame) },
    { "Final_Frame", WHOLE, AT(last_frame) },
    { "Frame_Step", WHOLE, AT(frame_step) },
    { "Subset_Start_Frame", SHORT, AT(subset_start) },
    { "Subset_End_Frame", SHORT, AT(subset_end) },
    { "Cyclic_Animation", BOOL, AT(cyclic) },
    { "Continue_Trace", BOOL, AT(resume) },
    { "Verbose", BOOL, AT(verbose) },
    { "Library_Path", LIST, AT(library) },
    { "Declare", LIST, AT(declares) },
    { "Include_Ini", SPECIAL, 0 },
    { "Jitter", FREE, 0 }, { "Jitter_Amount", FREE, 0 }, { "Antialias_Confidence", FREE, 0 }, { "Antialias_Gamma", FREE, 0 },
    { "Display", FREE, 0 }, { "Display_Gamma", FREE, 0 }, { "Pause_When_Done", FREE, 0 }, { "Palette", FREE, 0 },
    { "Video_Mode", FREE, 0 }, { "Preview_Start_Size", FREE, 0 }, { "Preview_End_Size", FREE, 0 },
    { "All_Console", FREE, 0 }, { "Debug_Console", FREE, 0 }, { "Fatal_Console", FREE, 0 }, { "Render_Console", FREE, 0 },
    { "Statistic_Console", FREE, 0 }, { "Warning_Console", FREE, 0 }, { "Warning_Level", FREE, 0 },
    { "Bounding", FREE, 0 }, { "Bounding_Threshold", FREE, 0 }, { "Bounding_Method", FREE, 0 }, { "Light_Buffer", FREE, 0 },
    { "Vista_Buffer", FREE, 0 }, { "Remove_Bounds", FREE, 0 }, { "Split_Unions", FREE, 0 }, { "BSP_MaxDepth", FREE, 0 },
    { "Test_Abort", FREE, 0 }, { "Test_Abort_Count", FREE, 0 }, { "Render_Block_Size", FREE, 0 }, { "Render_Pattern", FREE, 0 },
    { "High_Reproducibility", FREE, 0 }, { "Max_Image_Buffer_Memory", FREE, 0 }, { "Buffer_Output", FREE, 0 },
    { "Buffer_Size", FREE, 0 }, { "Compression", FREE, 0 }, { "Dither", FREE, 0 }, { "Dither_Method", FREE, 0 },
    { "Version", ALIEN, 0 }, { "Include_Header", ALIEN, 0 }, { "Create_Ini", ALIEN, 0 }, { "Grayscale_Output", ALIEN, 0 },
    { "All_File", ALIEN, 0 }, { "Debug_File", ALIEN, 0 }, { "Fatal_File", ALIEN, 0 }, { "Render_File", ALIEN, 0 },
    { "Statistic_File", ALIEN, 0 }, { "Warning_File", ALIEN, 0 }, { "Create_Histogram", ALIEN, 0 }, { "Histogram_Name", ALIEN, 0 },
    { "Field_Render", ALIEN, 0 }, { "Odd_Field", ALIEN, 0 }, { "Append_File", ALIEN, 0 },
};

/* +FN16: the letter, and the bits of a channel. */
static bool set_type(povray *p, const char *value)
{
    p->type = (char)toupper((unsigned char)value[0]);
    if (!strchr("NPTCJEHBSD", p->type) || p->type == '\0')
        return refuse(p, "there is no file type \"%s\"", value);
    return value[1] == '\0' || read_whole(p, "the number of bits behind the file type", value + 1, &p->bits);
}

static bool set_special(povray *p, const char *name, const char *value)
{
    if (strcasecmp(name, "Output_File_Type") == 0)
        return set_type(p, value);
    if (strcasecmp(name, "Include_Ini") == 0)
        return read_ini(p, value, NULL);
    p->has_clock = true;
    return read_real(p, name, value, &p->clock);
}

static bool apply(povray *p, const setting *s, const char *value)
{
    void *at = (char *)p + s->at;

    switch (s->kind) {
    case WHOLE:
        return read_whole(p, s->name, value, at);
    case REAL:
        return read_real(p, s->name, value, at);
    case BOOL:
        return read_bool(p, s->name, value, at);
    case TEXT:
        return read_text(p, s->name, value, at, POVRAY_TEXT);
    case SHORT:
        return read_text(p, s->name, value, at, sizeof p->subset_start);
    case LIST:
        return add(p, s->name, value, at);
    case SPECIAL:
        return set_special(p, s->name, value);
    case ALIEN:
        return is_off(value) || add(p, s->name, s->name, &p->ignored);
    default:
        return true;
    }
}

bool povray_set(povray *p, const char *name, const char *value)
{
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++)
        if (strcasecmp(settings[i].name, name) == 0)
            return apply(p, &settings[i], value);
    return add(p, name, name, &p->ignored);
}

/* ---- switches ---- */

/* A switch has an on and an off form, or a value, or both: +A, -A and +A0.1. */
typedef struct toggle { const char *letters, *name, *valued; } toggle;

/* Longer switches first, because they begin like shorter ones. */
static const toggle toggles[] = {
    { "kfi", NULL, "Initial_Frame" }, { "kff", NULL, "Final_Frame" }, { "kla", NULL, "" },
    { "am", NULL, "Sampling_Method" }, { "ac", NULL, "Antialias_Confidence" }, { "ag", NULL, "Antialias_Gamma" },
    { "bm", NULL, "Bounding_Method" }, { "bs", NULL, "Render_Block_Size" }, { "ef", NULL, "Subset_End_Frame" },
    { "ec", NULL, "End_Column" }, { "er", NULL, "End_Row" }, { "ep", NULL, "Preview_End_Size" },
    { "ga", "All_Console", "All_File" }, { "gd", "Debug_Console", "Debug_File" }, { "gf", "Fatal_Console", "Fatal_File" },
    { "gr", "Render_Console", "Render_File" }, { "gs", "Statistic_Console", "Statistic_File" },
    { "gw", "Warning_Console", "Warning_File" }, { "gi", NULL, "Create_Ini" }, { "gp", "Pause_When_Done", NULL },
    { "hi", NULL, "Include_Header" }, { "hr", "High_Reproducibility", NULL }, { "kc", "Cyclic_Animation", NULL },
    { "ki", NULL, "Initial_Clock" }, { "kf", NULL, "Final_Clock" }, { "mb", "Bounding", "Bounding_Threshold" },
    { "mi", NULL, "Max_Image_Buffer_Memory" }, { "mv", NULL, "Version" }, { "nr", "", NULL }, { "rp", NULL, "Render_Pattern" },
    { "sf", NULL, "Subset_Start_Frame" }, { "sc", NULL, "Start_Column" }, { "sr", NULL, "Start_Row" },
    { "ss", NULL, "Stochastic_Seed" }, { "sp", NULL, "Preview_Start_Size" }, { "su", "Split_Unions", NULL },
    { "ua", "Output_Alpha", NULL }, { "ud", "", NULL }, { "ul", "Light_Buffer", NULL }, { "ur", "Remove_Bounds", NULL },
    { "uv", "Vista_Buffer", NULL }, { "uo", "Odd_Field", NULL }, { "uf", "Field_Render", NULL },
    { "wl", NULL, "Warning_Level" }, { "wt", NULL, "Work_Threads" }, { "a", "Antialias", "Antialias_Threshold" },
    { "b", "Buffer_Output", "Buffer_Size" }, { "c", "Continue_Trace", NULL }, { "d", "Display", "" },
    { "f", "Output_To_File", "Output_File_Type" }, { "h", NULL, "Height" }, { "i", NULL, "Input_File_Name" },
    { "j", "Jitter", "Jitter_Amount" }, { "k", NULL, "Clock" }, { "l", NULL, "Library_Path" },
    { "o", NULL, "Output_File_Name" }, { "p", "Pause_When_Done", NULL }, { "q", NULL, "Quality" },
    { "r", NULL, "Antialias_Depth" }, { "v", "Verbose", NULL }, { "w", NULL, "Width" }, { "x", "Test_Abort", "Test_Abort_Count" },
};

static bool switch_setting(povray *p, const char *name, const char *value)
{
    return name[0] == '\0' || povray_set(p, name, value);
}

/* +WORD or -WORD. */
static bool read_switch(povray *p, const char *word)
{
    const char *sign = word[0] == '+' ? "on" : "off";

    for (size_t i = 0; i < sizeof toggles / sizeof toggles[0]; i++) {
        const toggle *t = &toggles[i];
        const size_t n = strlen(t->letters);
        const char *value = word + 1 + n;

        if (strncasecmp(word + 1, t->letters, n) != 0 || (value[0] == '\0' ? !t->name : !t->valued))
            continue;
        if (t->name && !switch_setting(p, t->name, sign))
            return false;
        return value[0] == '\0' || switch_setting(p, t->valued, value);
    }
    return add(p, word, word, &p->ignored);
}

/* ---- words and files ---- */

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
        return add(p, "a setting", word, &p->ignored);
    return povray_set(p, name, equals + 1);
}

/* A word of the command line, or of a line of switches in an INI file. */
static bool read_word(povray *p, const char *word)
{
    char copy[POVRAY_TEXT], *section;

    if ((word[0] == '+' || word[0] == '-') && word[1] != '\0')
        return read_switch(p, word);
    if (is_setting(word))
        return read_setting(p, word);
    if (!read_text(p, "a word of the command line", word, copy, sizeof copy))
        return false;
    section = cut_section(copy);
    if (ends_with(copy, ".ini") || section)
        return read_ini(p, copy, section);
    return read_text(p, "the input file", word, p->input, sizeof p->input);
}

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

/* A comment begins with ";" outside of quotation marks. */
static void cut_comment(char *line)
{
    char quote = '\0';

    for (; *line; line++) {
        if (quote ? *line == quote : *line == '"' || *line == '\'')
            quote = quote ? '\0' : *line;
        else if (*line == ';' && !quote)
            *line = '\0', line--;
        if (line[1] == '\0')
            return;
    }
}

static bool read_words(povray *p, char *line)
{
    char *word, *rest = NULL;

    for (word = strtok_r(line, " \t", &rest); word; word = strtok_r(NULL, " \t", &rest))
        if (!read_word(p, unquote(word)))
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
        return refuse(p, "\"%s\" is no setting", name);
    return read_setting(p, word);
}

/* Settings before the first [SECTION] always count, those behind it only where the section is asked for. */
static bool read_ini_lines(povray *p, FILE *in, const char *path, const char *section)
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

static bool read_ini(povray *p, const char *path, const char *section)
{
    char name[POVRAY_TEXT + 8];
    FILE *in;
    bool read;

    snprintf(name, sizeof name, ends_with(path, ".ini") ? "%s" : "%s.ini", path);
    in = fopen(name, "r");
    if (!in)
        return refuse(p, "cannot read the INI file \"%s\"", name);
    read = read_ini_lines(p, in, name, section);
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

static bool read_defaults(povray *p)
{
    const char *named = getenv("POVINI"), *home = getenv("HOME");
    char path[POVRAY_TEXT];
    FILE *in;

    if (named && named[0])
        return read_ini(p, named, NULL);
    in = fopen("povray.ini", "r");
    if (!in && home && (size_t)snprintf(path, sizeof path, "%s/.povray/3.7/povray.ini", home) < sizeof path)
        in = fopen(path, "r");
    if (in) {
        read_ini_lines(p, in, "povray.ini", NULL);
        fclose(in);
    }
    return !p->problem[0];
}

/* The ending may be left out. */
static void find_input(povray *p)
{
    char longer[POVRAY_TEXT + 4];

    if (!p->input[0] || strcmp(p->input, "-") == 0 || access(p->input, F_OK) == 0)
        return;
    snprintf(longer, sizeof longer, "%s.pov", p->input);
    if (access(longer, F_OK) == 0 && strlen(longer) < sizeof p->input)
        memcpy(p->input, longer, strlen(longer) + 1);
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
    p->first_frame = p->last_frame = p->frame_step = 1;
    if (!read_defaults(p))
        return false;
    for (int i = 1; i < argc; i++)
        if (!read_word(p, argv[i]))
            return false;
    find_input(p);
    if (!p->input[0])
        return refuse(p, "no scene is named: +ISCENE.pov, or SCENE.pov");
    if (p->width < 1 || p->height < 1 || p->width > 1000000 || p->height > 1000000)
        return refuse(p, "a picture of %d x %d pixels cannot be drawn", p->width, p->height);
    if (p->last_frame < p->first_frame || p->frame_step < 1)
        return refuse(p, "the animation ends before it begins");
    return true;
}
