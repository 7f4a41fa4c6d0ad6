#include "sdl/parse_image.h"

#include "sdl/image_decode.h"
#include "sdl/items.h"
#include "sdl/report.h"
#include "sdl/value.h"

#include <string.h>

typedef struct image_reading {
    image_map map;
    image_gamma gamma;
    image_alphas alphas;
    image_block *block;
} image_reading;

/* ---- the words ---- */

static void read_map_type(pov_reader *in, void *self, keyword_id keyword)
{
    const double type = value_number(in);

    (void)keyword;
    if (type != 0.0 && type != 1.0 && type != 2.0 && type != 5.0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"map_type\" must be 0, 1, 2 or 5");
    else
        ((image_reading *)self)->map.type = (image_map_type)type;
}

static void read_interpolate(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);
    const int how = number > 0.0 && number < 5.0 ? (int)number : 0;

    (void)keyword;
    ((image_reading *)self)->map.interpolation = how == 1 ? IMAGE_PIXELS : (image_interpolation)how;
}

static void read_switch(pov_reader *in, void *self, keyword_id keyword)
{
    image_map *map = &((image_reading *)self)->map;

    if (keyword == KEYWORD_ONCE)
        map->once = value_optional(in, 1.0) != 0.0;
    else if (keyword == KEYWORD_PREMULTIPLIED)
        map->premultiplied = value_optional(in, 1.0) != 0.0;
    else if (keyword == KEYWORD_USE_ALPHA)
        map->use_alpha = true;
    else
        map->use_index = keyword == KEYWORD_USE_INDEX;
}

static void set_entry(pov_reader *in, image_reading *r, float *entries, const char *word)
{
    const double number = value_number(in);
    float amount;

    state_accept(in, ',');
    amount = value_float(in);
    if (in->failed)
        return;
    if (r->map.image->colours == 0)
        report_fail(in, &in->value, POV_E_SYNTAX, "\"%s\" of an entry is for images with a palette", word);
    else if (!(number >= 0.0 && number < r->map.image->colours))
        report_fail(in, &in->value, POV_E_SYNTAX, "the image's palette has the entries 0 to %u", r->map.image->colours - 1);
    else
        entries[(int)number] = amount;
}

static void read_alpha(pov_reader *in, void *self, keyword_id keyword)
{
    image_reading *r = self;
    const bool is_filter = keyword == KEYWORD_FILTER;

    if (!state_accept_keyword(in, KEYWORD_ALL)) {
        set_entry(in, r, is_filter ? r->alphas.filter : r->alphas.transmit, is_filter ? "filter" : "transmit");
    } else if (is_filter) {
        r->map.filter = value_float(in);
    } else {
        r->map.transmit = value_float(in);
        r->alphas.has_transmit_all = true;
    }
}

static void read_bump_size(pov_reader *in, void *self, keyword_id keyword)
{
    image_block *b = ((image_reading *)self)->block;

    (void)keyword;
    b->bump_size = value_float(in);
    b->has_bump_size = true;
}

static const item items[] = {
    { KEYWORD_MAP_TYPE, read_map_type }, { KEYWORD_INTERPOLATE, read_interpolate }, { KEYWORD_ONCE, read_switch },
    { KEYWORD_USE_ALPHA, read_switch },  { KEYWORD_USE_INDEX, read_switch },        { KEYWORD_USE_COLOR, read_switch },
    { KEYWORD_USE_COLOUR, read_switch }, { KEYWORD_PREMULTIPLIED, read_switch },    { KEYWORD_FILTER, read_alpha },
    { KEYWORD_TRANSMIT, read_alpha },    { KEYWORD_BUMP_SIZE, read_bump_size },
};
static const item_list list = { "an item of the image", ITEMS(items), NULL, NULL, NULL, VALUE_NOTHING, NULL };

/* ---- blocks ---- */

enum { TEXTURES_MAX = 1 << 16 };

static void read_items(pov_reader *in, image_reading *r, bool has_textures)
{
    while (!in->failed && in->token.kind != '}') {
        if (items_try(in, &list, r))
            state_accept(in, ',');
        else if (!has_textures || r->block->textures.count > 0 ||
                 !parse_map_list(in, VALUE_TEXTURE_MAP, TEXTURES_MAX, &r->block->textures))
            items_refuse(in, &list);
    }
}

/* Brightness and heights are those of stored values; colours are decoded. */
static void read_block(pov_reader *in, const pattern_class *class, image_reading *r)
{
    const bool has_textures = class == &pattern_material_map;
    block b;

    items_open(in, &b);
    r->map.image = image_file_parse(in, &r->gamma, true);
    state_accept(in, ',');
    read_items(in, r, has_textures);
    in->block = b.outer;
    state_close(in, '}');
    if (!in->failed && has_textures && r->block->textures.count == 0)
        report_fail(in, &in->last, POV_E_SYNTAX, "\"material_map\" wants textures behind its image");
    r->map.count = r->block->textures.count;
    if (!in->failed)
        image_decode(in, &r->map, &r->gamma, &r->alphas, !class->colours);
}

static void read_volume(pov_reader *in, density_file *d)
{
    const string *name;

    if (!state_accept_keyword(in, KEYWORD_DF3)) {
        report_expected(in, "\"df3\"");
        return;
    }
    name = value_text(in);
    if (name)
        image_file_read_volume(in, name, d);
}

void parse_image(pov_reader *in, const pattern_class *class, void *self, image_block *out)
{
    image_reading r;

    memset(out, 0, sizeof *out);
    if (class == &pattern_density_file) {
        read_volume(in, self);
        return;
    }
    memset(&r, 0, sizeof r);
    r.block = out;
    for (int i = 0; i < 256; i++)
        r.alphas.filter[i] = r.alphas.transmit[i] = -1.0f;
    read_block(in, class, &r);
    memcpy(self, &r.map, sizeof r.map);
}
