#!/usr/bin/env python3
"""Where povc's instructions go, by parts of the program, and what caches and branches miss: a ray, under callgrind.

As in counts.py each scene is drawn in two sizes and the differences are divided by the difference of the rays, so start,
reading and building are left out. A function counts with all that was put into it inline. The caches are callgrind's
model of this machine's; what a processor fetches ahead it does not know.
"""
import argparse
import csv
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

import counts
import make_scenes
import programs

SCENES = ('flake-4', 'spheres-1e2', 'spheres-1e4', 'mixed-1e2', 'mixed-1e4', 'rings', 'tree', 'hall', 'glass',
          'strip')
# The first that fits a function's place, "object:file:function", is its part.
PARTS = (('filters', r'/primitives/.*(:plugins/common/\w*block|filter|block|:filter_rays)|lib/world/instance_filter'),
         # Functions that begin with what is inlined count as its header's.
         ('tree', r':lib/(bvh|query(?!/coincidence))/|:lib/world/leaf_batch|:take_rays'),
         ('instances', r':lib/world/instance|intrin\.h:instance_ray'),
         ('normals', r'/primitives/.*:(\w*normal|look)|:lib/world/surface|:lib/query/coincidence'),
         ('shapes', r'/primitives/'),
         ('shading', r':lib/(shade|world|model)/|libm\.so'),
         ('picture', r':lib/(render|api|base)/|/images/|:cli/|libc\.so|ld-linux|libz|libpng'))
FIELDS = ('scene', 'rays', 'all', *(part for part, _ in PARTS), 'other', 'near_misses', 'far_misses', 'branch_misses')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--functions', action='store_true', help='also print the dearest functions of each scene')
    parser.add_argument('scenes', nargs='*', default=SCENES)
    return parser.parse_args()


def part_of(place):
    return next((part for part, pattern in PARTS if re.search(pattern, place)), 'other')


def read_costs(path):
    """From callgrind's file: {place: Counter of events}, each function's own cost."""
    names, costs, current, called, events = {}, {}, {'ob': '', 'fl': '', 'fn': ''}, False, []

    def name_of(kind, text):
        number, _, name = re.match(r'\((\d+)\)( ?)(.*)', text).groups()
        kind = 'fl' if kind in ('fi', 'fe', 'cfi', 'cfl') else kind.lstrip('c')
        if name:
            names[kind, number] = name
        return names[kind, number]
    for line in path.read_text().splitlines():
        spec = re.match(r'(c?ob|fl|fi|fe|cfi|cfl|c?fn)=(.*)', line)
        if spec:
            name = name_of(*spec.groups())
            if spec[1] in current:
                current[spec[1]] = name
        elif line.startswith('events:'):
            events = line.split()[1:]
        elif line.startswith('calls='):
            called = True
        elif re.match(r'[-+*\d]', line):
            if not called:
                place = f'{current["ob"]}:{re.sub(".*/(?=(lib|cli|plugins)/)", "", current["fl"])}:{current["fn"]}'
                costs.setdefault(place, Counter()).update(dict(zip(events, map(int, line.split()[1:]))))
            called = False
    return costs


def run_of(povc, scene, width, height):
    """Costs and the number of rays."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / 'callgrind.out'
        said = programs.run(['valgrind', '--tool=callgrind', '--cache-sim=yes', '--branch-sim=yes',
                             f'--callgrind-out-file={out}', povc, scene, width, height, '/dev/null', '--format', 'pfm',
                             '--threads', 1, '--stats', '--progress', 'none'])
        return read_costs(out), programs.figures(said)['rays_total']


def measure(povc, name, scene):
    """The scene's row, and its dearest functions."""
    less, fewer = run_of(povc, scene, *counts.SMALL)
    more, rays = run_of(povc, scene, *counts.LARGE)
    per_ray = {place: {event: (cost - less.get(place, {}).get(event, 0)) / (rays - fewer) for event, cost in of.items()}
               for place, of in more.items()}

    def total(*events):
        return sum(of.get(event, 0.0) for of in per_ray.values() for event in events)
    row = dict.fromkeys(FIELDS, 0.0)
    row.update(scene=name, rays=rays, all=total('Ir'), near_misses=total('D1mr', 'D1mw'), far_misses=total('DLmr', 'DLmw'),
               branch_misses=total('Bcm', 'Bim'))
    for place, of in per_ray.items():
        row[part_of(place)] += of['Ir']
    dearest = sorted(((of['Ir'], place) for place, of in per_ray.items()), reverse=True)[:25]
    return row, dearest


def main():
    options = arguments()
    shown, rows = FIELDS[2:], []
    print(f'{"scene":<13}' + ''.join(f'{name.replace("_misses", ""):>11}' for name in shown), flush=True)
    for name in options.scenes:
        try:
            scene, _ = make_scenes.make(name, Path(options.work) / 'scenes', *counts.LARGE)
            row, dearest = measure(options.povc, name, scene)
        except (programs.ProgramError, ValueError) as error:
            sys.exit(f'bench-where: {name}: {error}')
        rows.append(row)
        print(f'{name:<13}' + ''.join(f'{row[field]:11.{2 if "misses" in field else 0}f}' for field in shown), flush=True)
        for cost, place in dearest if options.functions else ():
            print(f'{cost:24.1f}  {part_of(place):<11}{place.split("/")[-1] if ":" not in place else place}')
    with open(Path(options.work) / 'where.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)


if __name__ == '__main__':
    main()
