#!/usr/bin/env python3
"""Where each program stops being right: the same sweeps through povtrace, POV-Ray, Tachyon and Embree, pictures held
against exact masks. Writes peers.csv and a table in Markdown.

    peers.py --povc POVC [--embree EMBREE_MASK] --work FOLDER [--table FILE.md] [--quick]
"""
import argparse
import csv
import math
import os
import sys

import exact
import programs

N = 40
KINDS = ('sphere', 'box', 'cylinder', 'cone', 'quadric', 'polygon')
SEEN = ' pigment { color rgb 1 } finish { ambient 1 diffuse 0 } }\n'
WIDE = 3.0                       # width of the view, in sizes


def camera_at(distance, size=1.0, centre=(0.0, 0.0, 0.0)):
    """From the side, along (3, 0, 4): no coordinate is zero or exact by luck, and all of the frame is exact."""
    w, far = WIDE / distance, distance * size / 10.0
    return ((centre[0] - 6.0 * far, centre[1], centre[2] - 8.0 * far), (3.0, 0.0, 4.0), (4.0 * w, 0.0, -3.0 * w),
            (0.0, 5.0 * w, 0.0))


def camera_straight():
    w = WIDE / 10.0
    return (0.0, 0.0, -10.0), (0.0, 0.0, 1.0), (w, 0.0, 0.0), (0.0, w, 0.0)


MASKS = {}


def mask_of(kind, distance):
    if (kind, distance) not in MASKS:
        MASKS[kind, distance] = exact.mask(kind, camera_at(distance), N)
    return MASKS[kind, distance]


def share_wrong(picture, mask):
    judged = wrong = 0
    for row, wanted in zip(picture, mask):
        for value, hit in zip(row, wanted):
            judged += hit is not None
            wrong += hit is not None and (value > 0.5) != hit
    return wrong / judged


def share_off(picture, wanted, tolerance):
    values = [(v, w) for row, line in zip(picture, wanted) for v, w in zip(row, line) if w is not None]
    return sum(not abs(v - w) <= tolerance for v, w in values) / len(values)


def draw(program, camera, kind, size, centre):
    if hasattr(program, 'draw_shape'):
        return program.draw_shape(camera, kind, size, centre, N)
    return program.draw(camera, programs.povray_shape(kind, size, centre) + SEEN, N)


def text_only(program):
    if hasattr(program, 'draw_shape'):
        raise programs.Missing(program.name)


# ---- the families: each gives the share of wrong pixels for one value of its parameter ----

def distance(program, kind, d):
    return share_wrong(draw(program, camera_at(d), kind, 1.0, (0.0, 0.0, 0.0)), mask_of(kind, d))


def scale(program, kind, s):
    return share_wrong(draw(program, camera_at(10.0, s), kind, s, (0.0, 0.0, 0.0)), mask_of(kind, 10.0))


def translation(program, kind, m):
    """Whole numbers: the camera's distance of 10 stays exact."""
    centre = (m, -m, m)
    return share_wrong(draw(program, camera_at(10.0, 1.0, centre), kind, 1.0, centre), mask_of(kind, 10.0))


def acne(program, kind, size, centre):
    """Lit from the camera, a convex solid has no shadow on what is seen of it."""
    text_only(program)
    camera = camera_at(10.0, size, centre)
    light = 'light_source { %s color rgb 1 }\n' % programs.vector(camera[0])
    body = light + programs.povray_shape(kind, size, centre) + ' pigment { color rgb 1 } finish { ambient 0 diffuse 1 } }\n'
    dark = [[0.0 if v > 1e-3 else 1.0 for v in row] for row in program.draw(camera, body, N)]
    return share_wrong(dark, [[False if hit else None for hit in row] for row in mask_of(kind, 10.0)])


def acne_scale(program, kind, s):
    return acne(program, kind, s, (0.0, 0.0, 0.0))


def acne_translation(program, kind, m):
    return acne(program, kind, 1.0, (m, -m, m))


def slab(program, _kind, h):
    """Both faces of a slab of thickness h let half of the light through."""
    text_only(program)
    body = ('background { color rgb 1 } box { <-9,-9,0>, <9,9,%.17g> pigment { color rgbf <1,1,1,0.5> } '
            'finish { ambient 0 diffuse 0 } }\n' % h)
    return share_off(program.draw(camera_straight(), body, N), [[0.25] * N] * N, 0.01)


def occluder(program, _kind, h):
    """A floor seen, and lit, through a block of half the light a face that stands h before it: a sixteenth."""
    text_only(program)
    light = (1.0, 2.0, -30.0)
    body = ('light_source { %s color rgb 1 } box { <-9,-9,1>, <9,9,2> pigment { color rgb 1 } '
            'finish { ambient 0 diffuse 1 } }\n' % programs.vector(light))
    block = ('box { <-8,-8,0>, <8,8,%.17g> pigment { color rgbf <1,1,1,0.5> } finish { ambient 0 diffuse 0 } }\n' % (1.0 - h))
    wanted = []
    for py in range(N):
        row = []
        for px in range(N):
            x, y = (WIDE * 1.1 * ((px + 0.5) / N - 0.5), WIDE * 1.1 * (0.5 - (py + 0.5) / N))
            row.append(31.0 / math.dist((x, y, 1.0), light) / 16.0)
        wanted.append(row)
    return share_off(program.draw(camera_straight(), body + block, N), wanted, 0.002)


def silhouette(program, _kind, angle):
    camera = ((0.0, 0.0, -10.0), (3.0, 0.0, 4.0), (4.0 * angle, 0.0, -3.0 * angle), (0.0, 5.0 * angle, 0.0))
    return share_wrong(draw(program, camera, 'sphere', 6.0, (0.0, 0.0, 0.0)), exact.silhouette_mask(angle, N))


def powers(first, last):
    step = 1 if last >= first else -1
    return [float('1e%d' % e) for e in range(first, last + step, step)]


FAMILIES = (
    ('distance / size', distance, KINDS, powers(1, 12)),
    ('scale, down', scale, KINDS, powers(0, -12)),
    ('scale, up', scale, KINDS, powers(0, 12)),
    ('translation / size', translation, KINDS, powers(3, 12)),
    ('acne: scale, down', acne_scale, ('sphere', 'cylinder', 'box'), powers(0, -12)),
    ('acne: scale, up', acne_scale, ('sphere', 'cylinder', 'box'), powers(0, 12)),
    ('acne: translation / size', acne_translation, ('sphere', 'cylinder', 'box'), powers(3, 12)),
    ('slab thickness', slab, ('box',), powers(-1, -15)),
    ('occluder height', occluder, ('box',), powers(-1, -15)),
    ('silhouette, width of the view', silhouette, ('sphere',), powers(-1, -13)),
)


# ---- the sweeps ----

def sweep(family, program, kind, values):
    """(value, share of wrong pixels or an error's text) for each; ends behind three that are wrong by half or worse."""
    rows, bad = [], 0
    for value in values:
        try:
            share = family(program, kind, value)
        except RuntimeError as error:
            share = str(error)
        rows.append((value, share))
        bad = bad + 1 if isinstance(share, str) or share > 0.3 else 0
        if bad == 3:
            break
    return rows


def percent(share):
    if isinstance(share, str):
        return 'an error'
    return ('%.0f' if share > 0.095 else '%.2g') % (100 * share) + ' % wrong'


def summary(rows):
    """'right to 1e6; 1e7: 0.6 % wrong, 1e8: 48 % wrong'"""
    right, failed = None, []
    for value, share in rows:
        if failed or isinstance(share, str) or share > 0.0:
            failed.append((value, share))
        else:
            right = value
    if not failed:
        return 'right to %g, the last asked' % right
    start = 'right to %g' % right if right is not None else 'never right'
    return start + '; ' + ', '.join('%g: %s' % (value, percent(share)) for value, share in failed[:2])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--povc', required=True)
    parser.add_argument('--embree')
    parser.add_argument('--work', required=True)
    parser.add_argument('--table')
    parser.add_argument('--quick', action='store_true', help='every third value, spheres and boxes only')
    options = parser.parse_args()
    os.makedirs(options.work, exist_ok=True)
    all_programs = [made(options.work, options) for made in (programs.Povtrace, programs.PovRay, programs.Tachyon,
                                                             programs.Embree)]
    lines = ['| family | shape | ' + ' | '.join(p.name for p in all_programs) + ' |',
             '|---|---|' + '---|' * len(all_programs)]
    broken = 0
    with open(os.path.join(options.work, 'peers.csv'), 'w', newline='', encoding='ascii') as file:
        table = csv.writer(file)
        table.writerow(('family', 'kind', 'program', 'param', 'wrong'))
        for name, family, kinds, values in FAMILIES:
            for kind in kinds if not options.quick else [k for k in kinds if k in ('sphere', 'box')]:
                cells = []
                for program in all_programs:
                    try:
                        rows = sweep(family, program, kind, values[::3] if options.quick else values)
                    except programs.Missing:
                        cells.append('')
                        continue
                    for value, share in rows:
                        table.writerow((name, kind, program.name, '%g' % value, share))
                    cells.append(summary(rows))
                    broken += program.name == 'povtrace' and any(share != 0.0 for _, share in rows)
                lines.append('| %s | %s | %s |' % (name, kind, ' | '.join(cells)))
                print(lines[-1], flush=True)
    if options.table:
        with open(options.table, 'w', encoding='utf-8') as file:
            file.write('\n'.join(lines) + '\n')
    return 1 if broken else 0


if __name__ == '__main__':
    sys.exit(main())
