#include "render/part.h"

#include "base/err.h"
#include "base/file.h"
#include "base/hash.h"
#include "render/job_state.h"
#include "render/sample.h"

#include <math.h>
#include <string.h>

static const char magic_of_part[] = "povtrace-share\n", magic_of_round[] = "povtrace-round\n";

/* ---- sizes ---- */

static size_t groups_of(pov_rect tile)
{
    const cell_range r = cells_of(tile);

    return GROUPS * (size_t)r.columns * (size_t)r.rows;
}

/* Bytes of the counts of a group. */
static size_t size_of_group(const pov_job *job)
{
    return sizeof(uint32_t) + (job->cells.singles ? sizeof job->cells.singles->has : 0);
}

/* Bytes of a row of a tile. */
static size_t size_of_row(const pov_job *job, pov_rect tile)
{
    return (size_t)tile.width * (job->cells.halves ? (size_t)job->cells.sums * sizeof(double) : 4 * sizeof(float));
}

static size_t size_of_tile(const pov_job *job, size_t number)
{
    const pov_rect tile = tiles_rect(&job->tiles, number);

    return groups_of(tile) * size_of_group(job) + (size_t)tile.height * size_of_row(job, tile);
}

static size_t size_of_part(const pov_job *job, const tiles *t)
{
    size_t size = sizeof(part_head) + sizeof(uint64_t);

    for (size_t i = 0; i < t->own; i++)
        size += size_of_tile(job, t->order[i]);
    return size;
}

static size_t size_of_round(const pov_job *job)
{
    return sizeof(part_head) + GROUPS * job->cells.count * size_of_group(job) + sizeof(uint64_t);
}

/* A row of the job's halves or pixels, from (x, y) on. */
static unsigned char *row_at(const pov_job *job, int x, int y)
{
    const size_t pixel = (size_t)y * (size_t)job->tiles.width + (size_t)x;

    if (job->cells.halves)
        return (unsigned char *)(job->cells.halves + (size_t)job->cells.sums * pixel);
    return (unsigned char *)(job->framebuffer.pixels + 4 * pixel);
}

/* The first group of a row of a tile's cells. */
static size_t first_of_row(const pov_job *job, cell_range r, int row)
{
    return GROUPS * ((size_t)(r.row + row) * (size_t)job->cells.columns + (size_t)r.column);
}

/* ---- saving ---- */

static unsigned char *put_counts(const pov_job *job, uint32_t count, const uint8_t *of_singles, unsigned char *to)
{
    memcpy(to, &count, sizeof count);
    if (job->cells.singles)
        memcpy(to + sizeof count, of_singles, sizeof job->cells.singles->has);
    return to + size_of_group(job);
}

static unsigned char *put_tile(const pov_job *job, size_t number, unsigned char *to)
{
    const pov_rect tile = tiles_rect(&job->tiles, number);
    const cell_range r = cells_of(tile);

    for (int row = 0; row < r.rows; row++)
        for (int i = 0; i < GROUPS * r.columns; i++) {
            const size_t at = first_of_row(job, r, row) + (size_t)i;

            to = put_counts(job, job->cells.groups[at].count, job->cells.singles ? job->cells.singles[at].has : NULL, to);
        }
    for (int y = 0; y < tile.height; y++, to += size_of_row(job, tile))
        memcpy(to, row_at(job, tile.x, tile.y + y), size_of_row(job, tile));
    return to;
}

static unsigned char *put_head(const pov_job *job, unsigned char *to)
{
    const bool joined = job->joined != NULL;
    part_head head;

    memset(&head, 0, sizeof head);
    identity_of(job, joined ? magic_of_round : magic_of_part, &head.id);
    head.part = job->settings.part;
    head.round = joined ? job->round + 1 : job->round;
    head.decodes_srgb = job->encoding.decodes_srgb;
    head.alike = job->cells.alike;
    head.single = job->cells.singles != NULL;
    head.transfer = (int32_t)job->encoding.display.transfer;
    head.decode = job->encoding.decode;
    head.cpu = job->cpu;
    head.counts = job->counts;
    memcpy(head.note, job->note, sizeof head.note);
    memcpy(to, &head, sizeof head);
    return to + sizeof head;
}

static void image(const pov_job *job, unsigned char *to)
{
    to = put_head(job, to);
    if (job->joined)
        for (size_t i = 0; i < GROUPS * job->cells.count; i++)
            to = put_counts(job, job->cells.groups[i].target, job->cells.singles ? job->cells.singles[i].gets : NULL, to);
    else
        for (size_t i = 0; i < job->tiles.own; i++)
            to = put_tile(job, job->tiles.order[i], to);
}

static pov_status write(const pov_job *job, const char *file, unsigned char *bytes, size_t size, pov_error *err)
{
    const uint64_t hash = hash_bytes(0, bytes, size - sizeof hash);
    file_writer *writer = env_alloc(job->env, 1, sizeof *writer);
    pov_status status = writer ? file_writer_open(writer, job->env, file, err) : err_memory(err);

    if (status == POV_OK) {
        memcpy(bytes + size - sizeof hash, &hash, sizeof hash);
        file_writer_put(writer, bytes, size);
        status = file_writer_commit(writer, err);
    }
    env_free(job->env, writer);
    return status;
}

pov_status part_save(pov_job *job, const char *file, pov_error *err)
{
    unsigned char *bytes = NULL;
    size_t size = 0;
    bool complete;
    pov_status status;

    mutex_lock(&job->lock);
    complete = job->state == POV_JOB_DONE && job->stop == POV_STOP_PART;
    if (complete) {
        size = job->joined ? size_of_round(job) : size_of_part(job, &job->tiles);
        bytes = env_alloc(job->env, size, 1);
    }
    if (bytes)
        image(job, bytes);
    mutex_unlock(&job->lock);
    if (!complete)
        return err_set(err, POV_E_ARGUMENT, "a part is saved when it is complete, and a joined picture if its parts are to go on");
    status = bytes ? write(job, file, bytes, size, err) : err_memory(err);
    env_free(job->env, bytes);
    return status;
}

/* ---- reading ---- */

static bool is_whole(const char *bytes, size_t count)
{
    uint64_t hash;

    if (count < sizeof(part_head) + sizeof hash)
        return false;
    memcpy(&hash, bytes + count - sizeof hash, sizeof hash);
    return hash == hash_bytes(0, bytes, count - sizeof hash);
}

bool part_read_head(const char *bytes, size_t count, part_head *out)
{
    if (!is_whole(bytes, count))
        return false;
    memcpy(out, bytes, sizeof *out);
    return memcmp(out->id.magic, magic_of_part, sizeof magic_of_part) == 0 && identity_is_ours(&out->id) &&
           out->part >= 1 && out->part <= out->id.parts && out->round >= 1 && memchr(out->note, '\0', sizeof out->note);
}

/* The hash detects accidents, not forgers: impossible values must be refused too. */
static bool are_halves_possible(const unsigned char *at, size_t count)
{
    double sum;

    for (size_t i = 0; i < count; i++) {
        memcpy(&sum, at + i * sizeof sum, sizeof sum);
        if (!isfinite(sum))
            return false;
    }
    return true;
}

static bool take_singles(pov_job *job, size_t number, const unsigned char *at)
{
    singles *s = &job->cells.singles[number];

    if (!cells_are_singles_possible(&job->cells, number, at, job->wanted_singles ? job->wanted_singles[number].gets : at, true))
        return false;
    memcpy(s->has, at, sizeof s->has);
    memcpy(s->gets, at, sizeof s->gets);
    return true;
}

/* Counts of the groups of a tile; a count is at least one, and no more than the round wanted. */
static const unsigned char *take_counts(pov_job *job, pov_rect tile, const unsigned char *at)
{
    const cell_range r = cells_of(tile);

    for (int row = 0; row < r.rows; row++)
        for (int i = 0; i < GROUPS * r.columns; i++, at += size_of_group(job)) {
            const size_t number = first_of_row(job, r, row) + (size_t)i;
            uint32_t count;

            memcpy(&count, at, sizeof count);
            if (count < 1 || count > (uint32_t)SAMPLES_MAX || (job->wanted && count > job->wanted[number]))
                return NULL;
            job->cells.groups[number].count = job->cells.groups[number].target = count;
            if (job->cells.singles && !take_singles(job, number, at + sizeof count))
                return NULL;
        }
    return at;
}

/* Measure the tile's cells, and compute its pixels. */
static void show_tile(pov_job *job, size_t number, pov_rect tile, refinement *scratch, float *pixels)
{
    job->framebuffer.done[number] = (uint8_t)((1u << job->framebuffer.passes) - 1u);
    if (!job->cells.halves) {
        cells_first(&job->cells, tile, &job->framebuffer, &job->encoding);
        return;
    }
    cells_take(&job->cells, tile, scratch);
    cells_measure(&job->cells, tile, &job->encoding, scratch, pixels);
    cells_put(&job->cells, tile, scratch);
    framebuffer_replace(&job->framebuffer, number, pixels);
}

static const unsigned char *take_tile(pov_job *job, size_t number, const unsigned char *at)
{
    const pov_rect tile = tiles_rect(&job->tiles, number);
    const size_t row = size_of_row(job, tile);

    at = take_counts(job, tile, at);
    if (!at || (job->cells.halves && !are_halves_possible(at, (size_t)tile.height * row / sizeof(double))))
        return NULL;
    for (int y = 0; y < tile.height; y++, at += row)
        memcpy(row_at(job, tile.x, tile.y + y), at, row);
    return at;
}

static size_t samples_of(const pov_job *job, pov_rect tile)
{
    const cell_range r = cells_of(tile);
    size_t sum = 0;

    for (int row = 0; row < r.rows; row++)
        for (int i = 0; i < GROUPS * r.columns; i++) {
            const size_t number = first_of_row(job, r, row) + (size_t)i;

            sum += cells_samples(&job->cells, number);
        }
    return sum;
}

static pov_status take_tiles(pov_job *job, const tiles *t, const unsigned char *at, refinement *scratch, float *pixels)
{
    for (size_t i = 0; i < t->own; i++) {
        const pov_rect tile = tiles_rect(t, t->order[i]);

        at = take_tile(job, t->order[i], at);
        if (!at)
            return POV_E_IO;
        show_tile(job, t->order[i], tile, scratch, pixels);
        job->done_pixels += samples_of(job, tile);
    }
    return POV_OK;
}

/* The tiles of any part; tiles_free() them. */
static pov_status deal(const pov_job *job, int part, tiles *out)
{
    *out = job->tiles;
    out->order = NULL;
    if (!tiles_sort(out, job->env))
        return POV_E_MEMORY;
    tiles_deal(out, part, job->joined ? job->joined->parts : job->settings.parts);
    return POV_OK;
}

pov_status part_take(pov_job *job, const part_head *head, const char *bytes, size_t count)
{
    refinement *scratch = refinement_make(job->env, job->tiles.edge, job->cells.sums);
    float *pixels = env_alloc(job->env, (size_t)job->tiles.edge * (size_t)job->tiles.edge, 4 * sizeof *pixels);
    tiles theirs = { .order = NULL };
    pov_status status = scratch && pixels ? deal(job, head->part, &theirs) : POV_E_MEMORY;

    if (status == POV_OK && count != size_of_part(job, &theirs))
        status = POV_E_IO;
    if (status == POV_OK)
        status = take_tiles(job, &theirs, (const unsigned char *)bytes + sizeof *head, scratch, pixels);
    if (status == POV_OK) {
        job->cpu += head->cpu;
        counts_add(&job->counts, &head->counts);
    }
    tiles_free(&theirs, job->env);
    env_free(job->env, pixels);
    refinement_free(scratch, job->env);
    return status;
}

/* ---- a part that goes on ---- */

static bool are_targets_possible(const pov_job *job, const char *at)
{
    for (size_t i = 0; i < GROUPS * job->cells.count; i++) {
        uint32_t target;

        memcpy(&target, at + i * size_of_group(job), sizeof target);
        if (target < 1 || target > (uint32_t)SAMPLES_MAX)
            return false;
        if (job->cells.singles) {
            const unsigned char *gets = (const unsigned char *)at + i * size_of_group(job) + sizeof target;

            if (!cells_are_singles_possible(&job->cells, i, gets, gets, true))
                return false;
        }
    }
    return true;
}

static bool take_wanted(pov_job *job, const char *at)
{
    const size_t groups = GROUPS * job->cells.count;

    env_free(job->env, job->wanted);
    env_free(job->env, job->wanted_singles);
    job->wanted_singles = NULL;
    job->wanted = env_alloc(job->env, groups, sizeof *job->wanted);
    if (job->cells.singles)
        job->wanted_singles = env_alloc(job->env, groups, sizeof *job->wanted_singles);
    if (!job->wanted || (job->cells.singles && !job->wanted_singles))
        return false;
    for (size_t i = 0; i < groups; i++, at += size_of_group(job)) {
        memcpy(&job->wanted[i], at, sizeof *job->wanted);
        if (job->wanted_singles)
            memcpy(job->wanted_singles[i].gets, at + sizeof *job->wanted, sizeof job->wanted_singles->gets);
    }
    return true;
}

static pov_status load_round(pov_job *job, const char *file, const char *bytes, size_t count, pov_error *err)
{
    part_head theirs;
    identity ours;
    pov_status status;

    memcpy(&theirs, bytes, sizeof theirs);
    identity_of(job, magic_of_round, &ours);
    status = identity_check(&theirs.id, &ours, file, "round of parts", err);
    if (status < 0)
        return status;
    if (count != size_of_round(job) || theirs.round < 2 || !are_targets_possible(job, bytes + sizeof theirs))
        return err_file(err, POV_E_IO, file, "this round of parts is damaged");
    if (memcmp(theirs.note, job->note, sizeof theirs.note) != 0)
        return err_file(err, POV_E_ARGUMENT, file, "this round of parts was made with other options of the picture's file");
    if (!take_wanted(job, bytes + sizeof theirs))
        return err_memory(err);
    job->round = theirs.round;
    return POV_OK;
}

static pov_status load_own(pov_job *job, const char *file, const char *bytes, size_t count, pov_error *err)
{
    part_head theirs;
    identity ours;
    pov_status status;

    memcpy(&theirs, bytes, sizeof theirs);
    identity_of(job, magic_of_part, &ours);
    status = identity_check(&theirs.id, &ours, file, "part", err);
    if (status < 0)
        return status;
    if (!job->wanted || theirs.part != job->settings.part || theirs.round > job->round || !job->cells.halves)
        return err_file(err, POV_E_ARGUMENT, file, "a part goes on with its own file of an earlier round, and after that round");
    passes_begin(job);
    status = part_take(job, &theirs, bytes, count);
    if (status == POV_OK)
        job->claimed = job->committed = job->due;
    else
        passes_begin(job);
    return status == POV_E_IO ? err_file(err, POV_E_IO, file, "this part is damaged") : status < 0 ? err_memory(err) : POV_OK;
}

static pov_status load(pov_job *job, const char *file, const char *bytes, size_t count, pov_error *err)
{
    if (job->state != POV_JOB_IDLE)
        return err_set(err, POV_E_ARGUMENT, "a job takes up a checkpoint before it starts");
    if (!is_whole(bytes, count))
        return err_file(err, POV_E_IO, file, "this file is damaged, or none of a picture in parts");
    if (memcmp(bytes, magic_of_round, sizeof magic_of_round) == 0)
        return load_round(job, file, bytes, count, err);
    return load_own(job, file, bytes, count, err);
}

pov_status part_load(pov_job *job, const char *file, pov_error *err)
{
    char *bytes;
    size_t count;
    pov_status status = file_read(job->env, file, &bytes, &count, err);

    if (status < 0)
        return status;
    mutex_lock(&job->lock);
    status = load(job, file, bytes, count, err);
    mutex_unlock(&job->lock);
    env_free(job->env, bytes);
    return status;
}
