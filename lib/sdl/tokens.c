#include "sdl/tokens.h"

typedef struct row { const char *name; uint32_t flags; } row;

#define TOKEN_ROW(name, text, flags) { text, flags },
static const row words[WORD_COUNT] = { { "", 0 }, TOKEN_WORDS(TOKEN_ROW) };
#undef TOKEN_ROW

/* Words of POV-Ray's language that stand for features this version lacks. A row goes when its feature comes.
 * */
static const char *const later[] = {
    "aa_level", "aa_threshold", "abs", "absorption", "accuracy", "acos", "acosh", "adaptive", "agate",
    "agate_turb", "all", "all_intersections", "alpha", "altitude", "always_sample", "aoi", "aperture",
    "append", "arc_angle", "area_illumination", "area_light", "array", "asc", "ascii", "asin", "asinh",
    "atan", "atan2", "atanh", "autostop", "average", "b_spline", "bezier_spline", "bicubic_patch",
    "black_hole", "blob", "blur_samples", "bounded_by", "boxed", "bozo", "brick", "brick_size",
    "brightness", "brilliance", "bump_map", "bump_size", "bumps", "camera_view", "caustics", "ceil",
    "cells", "charset", "checker", "chr", "circular", "clipped_by", "clock", "clock_delta", "clock_on",
    "collect", "color_map", "colour_map", "component", "composite", "concat", "confidence",
    "conic_sweep", "conserve_energy", "contained_by", "control0", "control1", "coords", "cos", "cosh",
    "count", "crackle", "crand", "cube", "cubic", "cubic_spline", "cubic_wave", "cutaway_textures",
    "cylindrical", "degrees", "density", "density_file", "density_map", "dents", "df3", "difference",
    "dimension_size", "dimensions", "disc", "dispersion", "dispersion_samples", "dist_exp", "distance",
    "div", "double_illuminate", "eccentricity", "emission", "error_bound", "evaluate", "exp",
    "expand_thresholds",
    "exponent", "exterior", "extinction", "face_indices", "facets", "fade_color", "fade_colour",
    "fade_distance", "fade_power", "falloff", "falloff_angle", "false", "file_exists", "final_clock",
    "final_frame", "finite", "fisheye", "flatness", "flip", "floor", "focal_point", "fog", "fog_alt",
    "fog_offset", "fog_type", "form", "frame_number", "frequency", "fresnel", "function", "gather",
    "gif", "global_lights", "gradient", "granite", "gray", "gray_threshold", "height_field", "hexagon",
    "hf_gray_16", "hierarchy", "hypercomplex", "iff", "image_height", "image_map", "image_pattern",
    "image_width", "initial_clock", "initial_frame", "inside", "inside_vector", "int", "interior_texture",
    "internal", "interpolate", "intersection", "intervals", "irid", "irid_wavelength", "isosurface",
    "jitter", "jpeg", "julia", "julia_fractal", "lambda", "lathe", "lemon", "leopard", "light_group",
    "linear_spline", "linear_sweep", "ln", "load_file", "log", "looks_like", "low_error_factor", "magnet",
    "major_radius", "mandel", "map_type", "marble", "material", "material_map", "max", "max_extent",
    "max_gradient", "max_intersections", "max_iteration", "max_sample", "media", "media_attenuation",
    "media_interaction", "merge", "mesh", "mesh2", "mesh_camera", "method", "metric", "min", "min_extent",
    "minimum_reuse", "mm_per_unit", "mod", "mortar", "natural_spline", "nearest_count", "no", "no_bump_scale",
    "no_image", "no_radiosity", "no_reflection", "noise_generator", "normal", "normal_indices",
    "normal_map", "normal_vectors", "now", "number_of_waves", "object", "octaves", "off", "offset",
    "omega", "omnimax", "on", "once", "onion", "orient", "orientation", "orthographic", "panoramic",
    "parallel", "parametric", "pass_through", "pattern", "pavement", "perspective", "pgm", "phase",
    "photons", "pi", "pigment_map", "pigment_pattern", "planar", "plane", "png", "point_at",
    "pointlight", "poly", "poly_wave", "polynomial", "pot", "potential", "pow", "ppm", "precision",
    "precompute",
    "premultiplied", "pretrace_end", "pretrace_start", "prism", "projected_through", "pwr",
    "quadratic_spline", "quartic", "quaternion", "quick_color", "quick_colour", "quilted",
    "radial", "radians", "radiosity", "radius", "rainbow", "ramp_wave", "rand", "range", "ratio",
    "reciprocal", "recursion_limit", "reflection_exponent", "refraction", "repeat", "ripples", "roughness",
    "samples", "save_file", "scallop_wave", "scattering", "seed", "select", "shadowless", "sin",
    "sine_wave", "sinh",
    "size", "slice", "slope", "slope_map", "smooth", "smooth_triangle", "solid", "sor", "spacing",
    "specular", "sphere_sweep", "spherical", "spiral1", "spiral2", "spline", "split_union", "spotlight",
    "spotted", "sqr", "sqrt", "srgb", "srgbf", "srgbft", "srgbt", "str", "strcmp", "strength", "strlen",
    "strlwr", "strupr", "sturm", "substr", "subsurface", "superellipsoid", "t", "tan", "tanh",
    "target", "text", "texture_list", "texture_map", "tga", "thickness", "threshold", "tiff", "tightness",
    "tile2", "tiles", "tiling", "tolerance", "toroidal", "torus", "trace", "transform", "triangle",
    "triangle_wave", "true", "ttf", "turb_depth", "turbulence", "type", "u", "u_steps", "ultra_wide_angle",
    "union", "unofficial", "use_alpha", "use_color", "use_colour", "use_index", "utf8", "uv_indices",
    "uv_mapping", "uv_vectors", "v", "v_steps", "val", "variance", "vaxis_rotate", "vcross", "vdot",
    "vertex_vectors", "vlength", "vnormalize", "vrotate", "vstr", "vturbulence", "warp", "warning_level",
    "water_level", "waves", "width", "wood", "wrinkles", "x", "y", "yes", "z",
};

const char *token_word_name(word_id id)
{
    return words[id].name;
}

uint32_t token_word_flags(word_id id)
{
    return words[id].flags;
}

const char *token_word(size_t index, word_id *id, uint32_t *flags)
{
    const size_t known = WORD_COUNT - 1, unknown = sizeof later / sizeof later[0];

    *id = index < known ? (word_id)(index + 1) : WORD_OTHER;
    *flags = index < known ? words[index + 1].flags : TRAIT_LATER;
    if (index < known)
        return words[index + 1].name;
    return index - known < unknown ? later[index - known] : NULL;
}
