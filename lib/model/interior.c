#include "model/interior.h"

#include <string.h>

void interior_init(interior *i)
{
    memset(i, 0, sizeof *i);
    i->ior = i->dispersion = i->asked_dispersion = 1.0;
    i->dispersion_samples = 7;
}

void interior_set_ior(interior *i, double ior)
{
    i->ior = ior;
    i->has_ior = true;
    i->dispersion = i->asked_dispersion;
}

void interior_ask_dispersion(interior *i, double dispersion)
{
    i->asked_dispersion = dispersion;
    i->dispersion = i->has_ior ? dispersion : 1.0;
}

bool interior_equal(const interior *a, const interior *b)
{
    return a->given == b->given && a->ior == b->ior && a->dispersion == b->dispersion &&
           a->dispersion_samples == b->dispersion_samples && a->fade_distance == b->fade_distance &&
           a->fade_power == b->fade_power && colour_equal(a->fade_color, b->fade_color) && a->caustics == b->caustics &&
           a->media == b->media;
}
