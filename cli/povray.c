/* Settings and switches of POV-Ray. */
#include "povray_read.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- what is wrong, and what is odd ---- */

bool povray_refuse(povray *p, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    if (!p->problem[0])
        vsnprintf(p->problem, sizeof p->problem, format, list);
    va_end(list);
    return false;
}

void povray_doubt(povray *p, const char *format, ...)
{
    va_list list;

    va_start(list, format);
    if (p->doubts.count < POVRAY_LIST)
        vsnprintf(p->doubts.item[p->doubts.count++], POVRAY_TEXT, format, list);
    va_end(list);
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
    static const char *const words[] = { "off", "false", "no", "0", "" };

    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        if (strcasecmp(text, words[i]) == 0)
            return true;
    return false;
}

/* What is not "on" is off, as in POV-Ray. */
static void read_bool(povray *p, const char *name, const char *text, bool *out)
{
    if (!is_on(text) && !is_off(text))
        povray_doubt(p, "%s is on or off, not \"%.200s\"; taken as off", name, text);
    *out = is_on(text);
}

/* The number that the text begins with: as in POV-Ray, what stands behind it does not count. */
static bool read_real(povray *p, const char *name, const char *text, double *out)
{
    char *end;

    *out = strtod(text, &end);
    if (end == text)
        return povray_refuse(p, "%s must be a number, not \"%s\"", name, text);
    if (*end != '\0')
        povray_doubt(p, "%s=%.200s is read as %g", name, text, *out);
    return true;
}

/* Programs write fractions, too: they are cut off, as POV-Ray does. */
static bool read_whole(povray *p, const char *name, const char *text, int *out)
{
    char *end;
    const double value = strtod(text, &end);

    if (end == text || !(value >= -1e9 && value <= 1e9))
        return povray_refuse(p, "%s must be a whole number, not \"%s\"", name, text);
    *out = (int)value;
    if (*end != '\0')
        povray_doubt(p, "%s=%.200s is read as %d", name, text, *out);
    return true;
}

bool povray_read_text(povray *p, const char *name, const char *text, char *out, size_t size)
{
    if (strlen(text) >= size)
        return povray_refuse(p, "the value of %s is too long", name);
    strcpy(out, text);
    return true;
}

bool povray_add(povray *p, const char *name, const char *text, povray_list *to)
{
    if (to->count == POVRAY_LIST)
        return povray_refuse(p, "%s is given more than %d times", name, POVRAY_LIST);
    return povray_read_text(p, name, text, to->item[to->count++], POVRAY_TEXT);
}

/* ---- settings ---- */

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
    { "Radiosity_Vain_Pretrace", FREE, 0 }, { "Real_Time_Raytracing", FREE, 0 },
    { "Version", ALIEN, 0 }, { "Include_Header", ALIEN, 0 }, { "Create_Ini", ALIEN, 0 }, { "Grayscale_Output", ALIEN, 0 },
    { "All_File", ALIEN, 0 }, { "Debug_File", ALIEN, 0 }, { "Fatal_File", ALIEN, 0 }, { "Render_File", ALIEN, 0 },
    { "Statistic_File", ALIEN, 0 }, { "Warning_File", ALIEN, 0 }, { "Create_Histogram", ALIEN, 0 }, { "Histogram_Name", ALIEN, 0 },
    { "Radiosity_File_Name", ALIEN, 0 }, { "Radiosity_From_File", ALIEN, 0 }, { "Radiosity_To_File", ALIEN, 0 },
    { "Field_Render", ALIEN, 0 }, { "Odd_Field", ALIEN, 0 }, { "Append_File", ALIEN, 0 },
};

/* +FN16: the letter, the bits of a channel, and g for shades of grey. A word like PNG is its first letter. */
static bool set_type(povray *p, const char *value)
{
    char *end;
    long bits;

    p->type = (char)toupper((unsigned char)value[0]);
    if (!strchr("NPTCJEHB", p->type) || p->type == '\0')
        return povray_refuse(p, "there is no file type \"%s\"", value);
    bits = strtol(value + 1, &end, 10);
    if (end != value + 1 && bits > 0 && bits <= 64)
        p->bits = (int)bits;
    if (*end != '\0')
        povray_doubt(p, "Output_File_Type=%.200s is read as %.*s", value, (int)(end - value), value);
    return true;
}

static bool set_special(povray *p, const char *name, const char *value)
{
    if (strcasecmp(name, "Output_File_Type") == 0)
        return set_type(p, value);
    if (strcasecmp(name, "Include_Ini") == 0)
        return povray_read_ini(p, value);
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
        read_bool(p, s->name, value, at);
        return true;
    case TEXT:
        return povray_read_text(p, s->name, value, at, POVRAY_TEXT);
    case SHORT:
        return povray_read_text(p, s->name, value, at, sizeof p->subset_start);
    case LIST:
        return povray_add(p, s->name, value, at);
    case SPECIAL:
        return set_special(p, s->name, value);
    case ALIEN:
        return is_off(value) || povray_add(p, s->name, s->name, &p->ignored);
    default:
        return true;
    }
}

bool povray_set(povray *p, const char *name, const char *value)
{
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++)
        if (strcasecmp(settings[i].name, name) == 0)
            return apply(p, &settings[i], value);
    return povray_add(p, name, name, &p->ignored);
}

/* ---- switches ---- */

/* A switch has an on and an off form, or a value, or both: +A, -A and +A0.1. */
typedef struct toggle { const char *letters, *name, *valued; } toggle;

/* Longer switches first, because they begin like shorter ones. */
static const toggle toggles[] = {
    { "kfi", NULL, "Initial_Frame" }, { "kff", NULL, "Final_Frame" }, { "kla", NULL, "" },
    { "rfi", "Radiosity_From_File", NULL }, { "rfo", "Radiosity_To_File", NULL }, { "rtr", "Real_Time_Raytracing", NULL },
    { "rvp", "Radiosity_Vain_Pretrace", NULL }, { "rf", NULL, "Radiosity_File_Name" }, { "th", "Dither", "Dither_Method" },
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
bool povray_read_switch(povray *p, const char *word)
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
    return povray_add(p, word, word, &p->ignored);
}
