#include "sdl/noise.h"

#include "sdl/report.h"
#include "sdl/value.h"

const noise_tables *noise_of(pov_reader *in)
{
    model *m = in->model;

    if (!m->noise && !in->failed && !(m->noise = noise_create(m->env)))
        report_memory(in);
    return m->noise;
}

void noise_read_generator(pov_reader *in, void *self, keyword_id keyword)
{
    const double number = value_number(in);

    (void)self;
    (void)keyword;
    if (!in->failed && !(number >= 1.0 && number < 4.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"noise_generator\" must be 1, 2 or 3");
    else if (!in->failed)
        in->model->noise_generator = (int)number;
}

void noise_read_waves(pov_reader *in, void *self, keyword_id keyword)
{
    enum { MOST = 1000000 };
    const double number = value_number(in);

    (void)self;
    (void)keyword;
    if (!in->failed && !(number < MOST + 1.0))
        report_fail(in, &in->value, POV_E_SYNTAX, "\"number_of_waves\" must be %d at most", MOST);
    if (!in->failed && number < 1.0)
        report_warn(in, &in->value, "at least one wave is needed: 1 is taken");
    in->model->number_of_waves = in->failed || number < 1.0 ? 1 : (uint32_t)number;
}

void noise_finish(pov_reader *in)
{
    model *m = in->model;

    if (m->noise && !noise_want_waves(m->noise, &m->memory, m->number_of_waves))
        report_memory(in);
}
