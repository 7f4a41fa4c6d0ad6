/* povtrace/scene.h - a context, and the scenes loaded in it. */
#ifndef POVTRACE_SCENE_H
#define POVTRACE_SCENE_H

#include <povtrace/base.h>
#include <povtrace/math.h>

typedef struct pov_context pov_context;
typedef struct pov_scene pov_scene;
struct pov_plugin;

typedef struct pov_context_desc {
    size_t size;
    pov_allocator allocator;     /* resize NULL: malloc */
    pov_log_fn *log;             /* NULL: silent */
    void *log_user;
    /* Folders, colon separated; NULL: $POVTRACE_PLUGIN_PATH, else povtrace/ beside the library. A colon at the end stands
     * for these, behind the folders before it. */
    const char *plugin_path;
} pov_context_desc;

/* desc may be NULL. Any thread may load scenes in a context at any time; destroy must be the last call on it. Scenes
 * keep the resources they need, so a context may be destroyed before its scenes. */
POV_API pov_status pov_context_create(pov_context **out, const pov_context_desc *desc, pov_error *err);
POV_API void pov_context_destroy(pov_context *context);
/* Register a plugin that is linked into the program; it takes precedence over a file of the same keyword. The program
 * keeps it alive. */
POV_API pov_status pov_context_add_plugin(pov_context *context, const struct pov_plugin *plugin, pov_error *err);
/* The name and the file ("" for an added one) of the index-th plugin in use, or false past the last. */
POV_API bool pov_context_get_plugin(pov_context *context, size_t index, const char **name, const char **path);

typedef enum pov_dialect { POV_DIALECT_AUTO, POV_DIALECT_COURSE, POV_DIALECT_POVRAY } pov_dialect;
typedef enum pov_accel { POV_ACCEL_TREE, POV_ACCEL_NONE } pov_accel;
/* CERTIFIED: in double with an error bound, and in double-double where the bound leaves the result open. MAX: always in
 * double-double. */
typedef enum pov_accuracy { POV_ACCURACY_CERTIFIED, POV_ACCURACY_MAX } pov_accuracy;

/* The picture of an animation that a scene is read for: the values of clock, frame_number and so on in its text. */
typedef struct pov_animation {
    double clock, initial_clock, final_clock, clock_delta;
    int frame, initial_frame, final_frame;
} pov_animation;

/* How far reading may go; 0: a default that no honest scene meets. */
typedef struct pov_limits {
    size_t depth;                /* macros and included files within each other */
    size_t array, string;        /* elements of an array, bytes of a string */
    uint64_t turns;              /* of loops and calls of macros, together */
    size_t memory;               /* bytes of arrays, strings and other values, and of what loops make of the scene */
    double seconds;              /* of reading */
} pov_limits;

typedef struct pov_load_desc {
    size_t size;
    pov_dialect dialect;         /* AUTO: the text decides */
    pov_accel accel;             /* NONE: every ray tests every object; the pictures are bit-identical */
    int max_trace_level;         /* 0: the scene's; else this */
    int threads;                 /* for building; 0: one for each core */
    pov_accuracy accuracy;
    bool strict;                 /* language that is read and not drawn yet is an error, not a warning */
    int width, height;           /* image_width and image_height; 0: 320, 240 */
    const char *library_path;    /* folders of included files, colon separated, besides the scene's own; or NULL */
    const char *write_path;      /* the folder below which the scene may write files; NULL: it may not */
    const char *const *declares; /* "NAME=VALUE", a number or a quoted string, ending with NULL; or NULL */
    const pov_animation *animation;   /* NULL: one picture, clock 0 */
    pov_limits limits;
    bool soft_lights;            /* area lights are lit all over, by chance, and not at the points of their grids only */
    bool quick_colours;          /* pigments with a quick_color are that, as POV-Ray's at a Quality of 5 and below */
    uint64_t most_rays;          /* that may follow from one ray of the camera, shadow rays not counted: more is an error
                                  * while rendering; 0: a default that no honest scene meets, 10^8 */
    /* Called now and then by the thread that loads. fraction goes from 0 to 1/2 while the text is read, by the place in
     * it, and on to 1 while the scene is compiled, then in few steps; objects: read so far. False: the load ends with
     * POV_E_CANCELLED. NULL: nobody is told. */
    bool (*progress)(void *user, double fraction, size_t objects);
    void *progress_user;
    /* Bytes of the text and of all files that it reads, together; and of the pixels of its images, checked before they are
     * decoded. 0: no limit, but 1 GiB a file and 2 GiB an image. */
    size_t most_input, most_images;
} pov_load_desc;

/* Read scene text and compile it for rays. desc may be NULL. A loaded scene never changes, so any number of
 * threads may read it. */
POV_API pov_status pov_scene_load_file(pov_scene **out, pov_context *context, const char *path,
                                       const pov_load_desc *desc, pov_error *err);
/* `name` replaces the file's name in messages; text needs no terminating zero. */
POV_API pov_status pov_scene_load_text(pov_scene **out, pov_context *context, const char *text, size_t length,
                                       const char *name, const pov_load_desc *desc, pov_error *err);
POV_API void pov_scene_destroy(pov_scene *scene);

/* (u, v) is a position on the screen, each from -1/2 to 1/2. PERSPECTIVE: rays start at location, with the direction
 * direction + u right + v up. ORTHOGRAPHIC: they start at location + u right + v up, all with the same direction. The
 * others: as docs/language.md says; MESH sees by the faces of the scene that it came with. */
typedef enum pov_camera_type {
    POV_CAMERA_PERSPECTIVE, POV_CAMERA_ORTHOGRAPHIC, POV_CAMERA_FISHEYE, POV_CAMERA_ULTRA_WIDE, POV_CAMERA_OMNIMAX,
    POV_CAMERA_PANORAMIC, POV_CAMERA_SPHERICAL, POV_CAMERA_CYLINDER_1, POV_CAMERA_CYLINDER_2, POV_CAMERA_CYLINDER_3,
    POV_CAMERA_CYLINDER_4, POV_CAMERA_MESH, POV_CAMERA_TYPES
} pov_camera_type;

typedef struct pov_camera {
    size_t size;
    pov_vec3 location, direction, right, up;
    pov_camera_type type;
    double angles[2];            /* radians across and upwards, of those that have them */
    double lens_radius, focal_distance;   /* focal blur; 0: none */
    int lens_samples;            /* samples a pixel that a picture with blur takes if it says nothing else */
} pov_camera;

POV_API void pov_scene_get_camera(const pov_scene *scene, pov_camera *out);
/* The ray through a position on the screen, and through the middle of the lens. False: there is none. */
POV_API bool pov_camera_ray(const pov_camera *camera, double u, double v, pov_vec3 *org, pov_vec3 *dir);
/* Aim the camera from location at target, keeping its angles; sky points up in the picture. */
POV_API pov_status pov_camera_look_at(pov_camera *camera, pov_vec3 location, pov_vec3 target, pov_vec3 sky,
                                      pov_error *err);
POV_API size_t pov_scene_object_count(const pov_scene *scene);
/* Keyword and place of the index-th object in the text; false past the last. */
POV_API bool pov_scene_get_object(const pov_scene *scene, size_t index, const char **keyword, int *line, int *column);
/* Box around all finite objects; false when there is none. */
POV_API bool pov_scene_get_bounds(const pov_scene *scene, pov_box *out);

typedef struct pov_scene_info {
    size_t size;
    pov_dialect dialect;
    const char *dialect_reason;        /* the word that decided, or the reason; valid while the scene lives */
    pov_transfer transfer;             /* the scene's encoding for pictures stored as integers */
    double parse_seconds, build_seconds;
    size_t objects, infinite_objects, lights, materials, warnings;
    int max_trace_level;
    bool has_camera;                   /* false: it is seen from the origin along z, as POV-Ray does */
} pov_scene_info;

POV_API void pov_scene_get_info(const pov_scene *scene, pov_scene_info *out);

/* One row on a part that was compiled for this scene or left out, with the reason. */
typedef struct pov_plan_row { size_t size; bool used; const char *subject, *state, *reason; } pov_plan_row;
POV_API bool pov_scene_get_plan(const pov_scene *scene, size_t index, pov_plan_row *out);

#endif
