/* Objects that are kept while a scene is read are shorter than others: nothing reads behind them. Each block of memory ends
 * where memory ends, and objects before the kept ones move these through the blocks of the reader. */
#define _DEFAULT_SOURCE   /* MAP_ANONYMOUS */
#include "support/check.h"
#include "support/scenes.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { PADS = 64, TEXT_MAX = 1 << 13, HEAD = 16 };

/* The block of so many bytes, and a page behind it that cannot be read; the two sizes lie where it begins. */
static void *make(size_t bytes)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), behind = (bytes + HEAD - 1) / HEAD * HEAD + HEAD;
    const size_t all = (behind + page - 1) / page * page + page;
    unsigned char *from = mmap(NULL, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    size_t *sizes;

    if (from == MAP_FAILED)
        return NULL;
    mprotect(from + all - page, page, PROT_NONE);
    sizes = (size_t *)(void *)(from + all - page - behind);
    sizes[0] = bytes;
    sizes[1] = all;
    return (unsigned char *)sizes + HEAD;
}

static void take_away(void *block)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), *sizes = (const size_t *)(const void *)((unsigned char *)block - HEAD);
    unsigned char *from = (unsigned char *)block - HEAD;

    munmap(from - (uintptr_t)from % page, sizes[1]);
}

static void *resize(void *user, void *block, size_t bytes)
{
    void *fresh = bytes > 0 ? make(bytes) : NULL;

    (void)user;
    if (block && fresh) {
        const size_t old = ((size_t *)(void *)((unsigned char *)block - HEAD))[0];

        memcpy(fresh, block, old < bytes ? old : bytes);
    }
    if (block && (fresh || bytes == 0))
        take_away(block);
    return fresh;
}

/* The scene behind 0 to PADS - 1 spheres of a union. */
static void read_behind_others(const char *scene)
{
    pov_context_desc d = POV_INIT(d);
    pov_context *context;
    pov_error err;

    d.plugin_path = TEST_PLUGINS;
    d.allocator.resize = resize;
    assert_int_equal(pov_context_create(&context, &d, &err), POV_OK);
    for (int pads = 0; pads < PADS; pads++) {
        char text[TEXT_MAX];

        snprintf(text, sizeof text, "#version 3.7; union { sphere { 0, 1 } #for (I, 1, %d) sphere { I, 1 } #end } %s", pads, scene);
        pov_scene_destroy(scenes_text(context, text));
    }
    pov_context_destroy(context);
}

static void copies_of_declared_solids_end_in_their_memory(void **state)
{
    (void)state;
    read_behind_others("#declare T = union { #for (I, 1, 6) sphere { I*x, .5 } #end } object { T translate y } object { T }");
}

static void what_clips_ends_in_its_memory(void **state)
{
    (void)state;
    read_behind_others("#declare T = sphere { 0, 1 clipped_by { box { -1, 0 } } bounded_by { box { -2, 2 } } } #declare E = min_extent(T); "
                       "#declare U = object { T rotate y } #declare F = max_extent(U); object { U }");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(copies_of_declared_solids_end_in_their_memory),
        cmocka_unit_test(what_clips_ends_in_its_memory),
    };

    return cmocka_run_group_tests(tests, NULL, NULL);
}
