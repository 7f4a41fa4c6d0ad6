#include "sdl/noise.h"

#include "sdl/report.h"

const noise_tables *noise_of(pov_reader *in)
{
    model *m = in->model;

    if (!m->noise && !in->failed && !(m->noise = noise_create(m->env)))
        report_memory(in);
    return m->noise;
}

void noise_finish(pov_reader *in)
{
    model *m = in->model;

    if (m->noise && !noise_want_waves(m->noise, &m->memory, m->number_of_waves))
        report_memory(in);
}
