#include "render/job_state.h"

#include "base/clock.h"
#include "base/err.h"
#include "base/file.h"
#include "base/hash.h"
#include "base/vec.h"
#include "render/part.h"
#include "render/sample.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A checkpoint is a memory image for the machine and the version that wrote it: both are checked, and so is every byte.
 * In order: identity, state, rows, counts and targets of the groups, and of single pixels. Then, while lattices are traced, the finished
 * passes of each square and the pixels; afterwards the halves. The last part is the hash of all that. */

enum { SQUARE = TILE_EDGE_MIN };

static const char magic[] = "povtrace-part\n";

typedef struct state {
    uint64_t rows;
    uint32_t refining, reserved;
    double elapsed, cpu;
    pov_counts counts, lattices[LATTICES_MAX];
    class_counts classes;
} state;

/* ---- squares: what tiles are made of, whatever their size ---- */

static size_t square_columns(const pov_job *job)
{
    return ((size_t)job->tiles.width - 1) / SQUARE + 1;
}

static size_t square_count(const pov_job *job)
{
    return square_columns(job) * (((size_t)job->tiles.height - 1) / SQUARE + 1);
}

static size_t tile_of_square(const pov_job *job, size_t square)
{
    size_t x = square % square_columns(job) * SQUARE, y = square / square_columns(job) * SQUARE;
    size_t edge = (size_t)job->tiles.edge;

    return y / edge * (size_t)job->tiles.columns + x / edge;
}

static size_t pixel_count(const pov_job *job)
{
    return (size_t)job->tiles.width * (size_t)job->tiles.height;
}

static size_t size_of_halves(const pov_job *job) { return (size_t)job->cells.sums * sizeof(double) * pixel_count(job); }

/* ---- saving ---- */

static size_t size_of_groups(const pov_job *job)
{
    const singles *s = job->cells.singles;

    return GROUPS * job->cells.count * (8 + (s ? sizeof s->has + sizeof s->gets : 0));
}

static size_t size_of(const pov_job *job, size_t rows, bool refining)
{
    size_t size = sizeof(identity) + sizeof(state) + rows * sizeof(pov_pass) + size_of_groups(job);

    size += refining ? size_of_halves(job) : square_count(job) + 4 * sizeof(float) * pixel_count(job);
    return size + sizeof(uint64_t);
}

static unsigned char *put(unsigned char *to, const void *from, size_t count)
{
    if (count > 0)
        memcpy(to, from, count);
    return to + count;
}

/* The rows of whole passes. */
static size_t row_count(const pov_job *job)
{
    return job->rows.count - (job->last_is_partial ? 1 : 0);
}

/* All but the hash. The lock is held. */
static void image(const pov_job *job, unsigned char *to)
{
    identity id;
    state s;

    identity_of(job, magic, &id);
    memset(&s, 0, sizeof s);
    s.rows = row_count(job);
    s.refining = job->refining;
    s.elapsed = (job->ended > 0.0 ? job->ended : clock_seconds()) - job->started;
    s.cpu = job->cpu;
    s.counts = job->counts;
    for (int i = 0; i < LATTICES_MAX; i++)
        s.lattices[i] = job->lattices[i].counts;
    s.classes = job->classes;
    to = put(to, &id, sizeof id);
    to = put(to, &s, sizeof s);
    to = put(to, job->rows.items, row_count(job) * sizeof *job->rows.items);
    for (size_t i = 0; i < GROUPS * job->cells.count; i++) {
        to = put(to, &job->cells.groups[i].count, 4);
        to = put(to, &job->cells.groups[i].target, 4);
    }
    for (size_t i = 0; job->cells.singles && i < GROUPS * job->cells.count; i++) {
        to = put(to, job->cells.singles[i].has, sizeof job->cells.singles->has);
        to = put(to, job->cells.singles[i].gets, sizeof job->cells.singles->gets);
    }
    if (job->refining) {
        put(to, job->cells.halves, size_of_halves(job));
        return;
    }
    for (size_t i = 0; i < square_count(job); i++)
        *to++ = job->framebuffer.done[tile_of_square(job, i)];
    put(to, job->framebuffer.pixels, 4 * sizeof(float) * pixel_count(job));
}

static pov_status save_checkpoint(pov_job *job, const char *file, pov_error *err)
{
    file_writer *writer = env_alloc(job->env, 1, sizeof *writer);
    unsigned char *bytes;
    size_t size;
    uint64_t hash;
    pov_status status;

    if (!writer)
        return err_memory(err);
    mutex_lock(&job->lock);
    size = size_of(job, row_count(job), job->refining);
    bytes = env_alloc(job->env, size, 1);
    if (bytes)
        image(job, bytes);
    mutex_unlock(&job->lock);
    status = bytes ? file_writer_open(writer, job->env, file, err) : err_memory(err);
    if (status == POV_OK) {
        hash = hash_bytes(0, bytes, size - sizeof hash);
        memcpy(bytes + size - sizeof hash, &hash, sizeof hash);
        file_writer_put(writer, bytes, size);
        status = file_writer_commit(writer, err);
    }
    env_free(job->env, bytes);
    env_free(job->env, writer);
    return status;
}

/* ---- going on ---- */

static pov_status check(const pov_job *job, const char *file, const char *bytes, size_t count, pov_error *err)
{
    identity ours, theirs;

    identity_of(job, magic, &ours);
    if (count < sizeof theirs + sizeof(state))
        return err_file(err, POV_E_IO, file, "this is no checkpoint");
    memcpy(&theirs, bytes, sizeof theirs);
    return identity_check(&theirs, &ours, file, "checkpoint", err);
}

/* Is the file complete and unchanged? */
static pov_status check_whole(const pov_job *job, const char *file, const char *bytes, size_t count, pov_error *err)
{
    uint64_t hash;
    state s;

    memcpy(&s, bytes + sizeof(identity), sizeof s);
    if (s.rows > 1u << 24 || s.refining > 1 || (s.refining && !job->settings.sampling) ||
        count != size_of(job, (size_t)s.rows, s.refining))
        return err_file(err, POV_E_IO, file, "this checkpoint is damaged");
    memcpy(&hash, bytes + count - sizeof hash, sizeof hash);
    if (hash != hash_bytes(0, bytes, count - sizeof hash))
        return err_file(err, POV_E_IO, file, "this checkpoint is damaged");
    return POV_OK;
}

/* The hash detects accidents, not forgers: impossible values must be refused too. */
static bool are_groups_possible(const pov_job *job, const unsigned char *at, bool refining)
{
    for (size_t i = 0; i < GROUPS * job->cells.count; i++, at += 8) {
        uint32_t count, target;

        memcpy(&count, at, 4);
        memcpy(&target, at + 4, 4);
        if (count > target || target > SAMPLES_MAX || (refining && count < 1))
            return false;
    }
    for (size_t i = 0; job->cells.singles && i < GROUPS * job->cells.count; i++, at += 2 * sizeof job->cells.singles->has)
        if (!cells_are_singles_possible(&job->cells, i, at, at + sizeof job->cells.singles->has, refining))
            return false;
    return true;
}

static bool are_halves_possible(const pov_job *job, const unsigned char *at)
{
    double sum;

    for (size_t i = 0; i < size_of_halves(job) / sizeof sum; i++) {
        memcpy(&sum, at + i * sizeof sum, sizeof sum);
        if (!isfinite(sum))
            return false;
    }
    return true;
}

static bool are_lattices_possible(const pov_job *job, const unsigned char *bits)
{
    for (size_t i = 0; i < square_count(job); i++)
        if (bits[i] >> job->framebuffer.passes)
            return false;
    return true;
}

static pov_status check_possible(const pov_job *job, const char *file, const char *bytes, pov_error *err)
{
    const unsigned char *at = (const unsigned char *)bytes + sizeof(identity) + sizeof(state);
    bool possible;
    state s;

    memcpy(&s, bytes + sizeof(identity), sizeof s);
    at += s.rows * sizeof(pov_pass);
    possible = s.elapsed >= 0.0 && isfinite(s.elapsed) && s.cpu >= 0.0 && isfinite(s.cpu) &&
               are_groups_possible(job, at, s.refining);
    at += size_of_groups(job);
    possible = possible && (s.refining ? are_halves_possible(job, at) : are_lattices_possible(job, at));
    return possible ? POV_OK : err_file(err, POV_E_IO, file, "this checkpoint holds numbers that no render leaves");
}

/* Convert the passes of squares to those of tiles: a tile has the passes that all of its squares have. Its first
 * samples are counted in the cells again. */
static void take_lattices(pov_job *job, const unsigned char *bits)
{
    size_t tiles_count = job->tiles.count;

    memset(job->framebuffer.done, 0xff, tiles_count);
    for (size_t i = 0; i < square_count(job); i++)
        job->framebuffer.done[tile_of_square(job, i)] &= bits[i];
    memcpy(job->framebuffer.pixels, bits + square_count(job), 4 * sizeof(float) * pixel_count(job));
    cells_clear(&job->cells);
    for (size_t i = 0; i < tiles_count; i++) {
        pov_rect r = tiles_rect(&job->tiles, i);

        for (int pass = 0; pass < job->framebuffer.passes; pass++)
            if (job->framebuffer.done[i] >> pass & 1u) {
                job->committed++;
                job->lattices[pass].tiles++;
                job->done_pixels += lattice_pixels(framebuffer_lattice(&job->framebuffer, pass), r.width, r.height);
            }
        if (framebuffer_has(&job->framebuffer, i))
            cells_first(&job->cells, r, &job->framebuffer, &job->encoding);
    }
    while (job->lattices_ended + 1 < job->framebuffer.passes && job->lattices[job->lattices_ended].tiles == tiles_count)
        job->lattices_ended++;
    passes_skip(job);
}

static void take_halves(pov_job *job, const unsigned char *halves, refinement *part, float *pixels)
{
    memcpy(job->cells.halves, halves, size_of_halves(job));
    for (size_t i = 0; i < job->tiles.count; i++) {
        pov_rect r = tiles_rect(&job->tiles, i);

        cells_take(&job->cells, r, part);
        cells_measure(&job->cells, r, &job->encoding, part, pixels);
        cells_put(&job->cells, r, part);
        job->framebuffer.done[i] = (uint8_t)((1u << job->framebuffer.passes) - 1u);
        framebuffer_replace(&job->framebuffer, i, pixels);
    }
    for (size_t i = 0; i < GROUPS * job->cells.count; i++)
        job->done_pixels += cells_samples(&job->cells, i);
    passes_queue(job);
}

static bool take_rows(pov_job *job, const unsigned char *at, size_t count)
{
    pov_pass row;

    for (size_t i = 0; i < count; i++) {
        memcpy(&row, at + i * sizeof row, sizeof row);
        if (!VEC_PUSH(job->env, &job->rows, row))
            return false;
    }
    return true;
}

/* The contents are valid: take them. The lock is held. */
static pov_status take(pov_job *job, const unsigned char *at, pov_error *err)
{
    refinement *part = refinement_make(job->env, job->tiles.edge, job->cells.sums);
    float *pixels = env_alloc(job->env, (size_t)job->tiles.edge * (size_t)job->tiles.edge, 4 * sizeof *pixels);
    pov_status status = part && pixels ? POV_OK : err_memory(err);
    state s;

    passes_begin(job);
    memcpy(&s, at + sizeof(identity), sizeof s);
    at += sizeof(identity) + sizeof s;
    if (status == POV_OK && !take_rows(job, at, (size_t)s.rows))
        status = err_memory(err);
    at += s.rows * sizeof(pov_pass);
    if (status == POV_OK) {
        for (size_t i = 0; i < GROUPS * job->cells.count; i++, at += 8) {
            memcpy(&job->cells.groups[i].count, at, 4);
            memcpy(&job->cells.groups[i].target, at + 4, 4);
        }
        for (size_t i = 0; job->cells.singles && i < GROUPS * job->cells.count; i++, at += 2 * sizeof job->cells.singles->has) {
            memcpy(job->cells.singles[i].has, at, sizeof job->cells.singles->has);
            memcpy(job->cells.singles[i].gets, at + sizeof job->cells.singles->has, sizeof job->cells.singles->gets);
        }
        job->earlier = s.elapsed;
        job->cpu = s.cpu;
        job->counts = s.counts;
        for (int i = 0; i < LATTICES_MAX; i++)
            job->lattices[i].counts = s.lattices[i];
        job->classes = s.classes;
        if (s.refining)
            take_halves(job, at, part, pixels);
        else
            take_lattices(job, at);
    }
    env_free(job->env, pixels);
    refinement_free(part, job->env);
    return status;
}

static pov_status load_checkpoint(pov_job *job, const char *file, pov_error *err)
{
    char *bytes;
    size_t count;
    pov_status status = file_read(job->env, file, &bytes, &count, err);

    if (status < 0)
        return status;
    mutex_lock(&job->lock);
    if (job->state != POV_JOB_IDLE)
        status = err_set(err, POV_E_ARGUMENT, "a job takes up a checkpoint before it starts");
    if (status == POV_OK)
        status = check(job, file, bytes, count, err);
    if (status == POV_OK)
        status = check_whole(job, file, bytes, count, err);
    if (status == POV_OK)
        status = check_possible(job, file, bytes, err);
    if (status == POV_OK)
        status = take(job, (const unsigned char *)bytes, err);
    mutex_unlock(&job->lock);
    env_free(job->env, bytes);
    return status;
}

pov_status job_save(pov_job *job, const char *file, pov_error *err)
{
    return job->settings.parts > 0 || job->joined ? part_save(job, file, err) : save_checkpoint(job, file, err);
}

pov_status job_load(pov_job *job, const char *file, pov_error *err)
{
    return job->settings.parts > 0 ? part_load(job, file, err) : load_checkpoint(job, file, err);
}
