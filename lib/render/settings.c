#include "render/settings.h"

#include "base/err.h"
#include "base/thread.h"
#include "render/raygen.h"

#include <math.h>
#include <string.h>

/* Pictures are no wider or higher than this, so that sums of pixel coordinates stay far from overflow. */
enum { EDGE_MAX = 1 << 28 };

static pov_status check_size(const pov_render_desc *d, pov_error *err)
{
    if (d->width < 1 || d->height < 1)
        return err_set(err, POV_E_ARGUMENT, "a picture of %d x %d pixels has none", d->width, d->height);
    if (d->width > EDGE_MAX || d->height > EDGE_MAX)
        return err_set(err, POV_E_ARGUMENT, "a picture of %d x %d pixels is too large: %d is the most either way",
                       d->width, d->height, (int)EDGE_MAX);
    return POV_OK;
}

static pov_status take_crop(settings *s, const pov_render_desc *d, pov_error *err)
{
    pov_rect c = d->crop;

    if (c.width == 0) {
        s->crop.x = s->crop.y = 0;
        s->crop.width = d->width;
        s->crop.height = d->height;
        return POV_OK;
    }
    if (c.x < 0 || c.y < 0 || c.width < 0 || c.height < 1 || c.x > d->width - c.width || c.y > d->height - c.height)
        return err_set(err, POV_E_ARGUMENT, "a crop of %d x %d pixels at %d, %d is not within a picture of %d x %d",
                       c.width, c.height, c.x, c.y, d->width, d->height);
    s->crop = c;
    return POV_OK;
}

static pov_status take_preview(settings *s, const pov_render_desc *d, pov_error *err)
{
    int p = d->preview;

    if (p != 0 && p != 2 && p != 4 && p != 8 && p != 16)
        return err_set(err, POV_E_ARGUMENT, "a preview begins with pixels of 2, 4, 8 or 16, or is 0 for none, not %d",
                       p);
    s->first_step = p > 0 ? p : 1;
    return POV_OK;
}

static pov_status take_numbers(settings *s, const pov_render_desc *d, pov_error *err)
{
    if (d->samples < 0 || d->samples > SAMPLES_MAX)
        return err_set(err, POV_E_ARGUMENT, "a pixel has 1 to %d samples, not %d", (int)SAMPLES_MAX, d->samples);
    if (d->threads < 0)
        return err_set(err, POV_E_ARGUMENT, "a job has threads or 0 for one a core, not %d", d->threads);
    if (!(d->target_error >= 0.0) || !isfinite(d->target_error))
        return err_set(err, POV_E_ARGUMENT, "the error to reach is a number above 0, or 0 for none");
    if (!(d->time_limit >= 0.0))
        return err_set(err, POV_E_ARGUMENT, "the time limit is a number of seconds above 0, or 0 for none");
    if (d->sampling != POV_SAMPLING_UNIFORM && d->sampling != POV_SAMPLING_ADAPTIVE)
        return err_set(err, POV_E_ARGUMENT, "unknown way of sampling");
    s->samples = d->samples > 0 ? d->samples : d->target_error > 0.0 || d->time_limit > 0.0 ? SAMPLES_MAX : s->samples;
    s->sampling = s->samples > 1;
    s->adaptive = d->sampling == POV_SAMPLING_ADAPTIVE;
    s->target_error = d->target_error;
    s->time_limit = d->time_limit;
    s->seed = d->seed;
    s->reference = d->reference;
    s->reference_clipped = d->reference_clipped;
    s->threads = d->threads > 0 ? d->threads : thread_cores();
    return POV_OK;
}

static pov_status take_part(settings *s, const pov_render_desc *d, pov_error *err)
{
    if (d->part < 0 || d->parts < 0 || d->part > d->parts || (d->part == 0) != (d->parts == 0))
        return err_set(err, POV_E_ARGUMENT, "part %d of %d: parts are numbered 1 to their number", d->part, d->parts);
    if (d->parts > 0 && (d->time_limit > 0.0 || d->preview > 0))
        return err_set(err, POV_E_ARGUMENT, "a part of a picture has no time limit and no preview");
    if (d->parts > 0 && d->note && strlen(d->note) >= SETTINGS_NOTE)
        return err_set(err, POV_E_ARGUMENT, "the note of a part has at most %d characters", SETTINGS_NOTE - 1);
    s->part = d->part;
    s->parts = d->parts;
    s->note = d->note;
    return POV_OK;
}

/* Does the scene alone say how many samples a pixel gets at most? A mesh camera's are no matter of chance. */
static bool is_sampled_by_lens(const pov_render_desc *d, const pov_camera *camera)
{
    return raygen_has_lens(camera) && camera->type != POV_CAMERA_MESH && d->samples == 0 && d->sampling == POV_SAMPLING_UNIFORM &&
           !(d->target_error > 0.0) && !(d->time_limit > 0.0);
}

pov_status settings_make(settings *s, const pov_render_desc *desc, const pov_camera *camera, pov_error *err)
{
    pov_status status = check_size(desc, err);

    s->samples = raygen_counts(camera) && camera->lens_samples > 1 ? camera->lens_samples : 1;
    s->ends_early = is_sampled_by_lens(desc, camera);
    s->width = desc->width;
    s->height = desc->height;
    s->wake = desc->wake;
    s->wake_user = desc->wake_user;
    s->time_map = desc->time_map != 0;
    s->alpha = desc->alpha != 0;
    if (status == POV_OK)
        status = take_crop(s, desc, err);
    if (status == POV_OK)
        status = take_preview(s, desc, err);
    if (status == POV_OK)
        status = take_part(s, desc, err);
    return status == POV_OK ? take_numbers(s, desc, err) : status;
}
