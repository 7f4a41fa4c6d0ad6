#!/usr/bin/env python3
"""Counts povc's instructions a ray under callgrind and holds them against the stored counts.

Each scene is drawn in two sizes; the difference of the instructions by the difference of the rays leaves out the start,
reading, building and the end. With a clock that stands still (still.c) the counts are the same on a busy machine, so 3 per cent
can be asked for; they depend on the compiler.
"""
import argparse
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import make_scenes
import programs
import scenes

HERE = Path(__file__).resolve().parent
SMALL, LARGE = (96, 72), (192, 144)
LIMIT = 0.03
SCENES = tuple(f'pair-{kind}' for kind in scenes.PAIRS) + ('flake-3', 'spheres-1e4', 'mixed-1e3', 'rings-8', 'tree-6',
                                                           'hall-4', 'glass-3', 'strip-2000')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--stored', default=str(HERE / 'counts.txt'))
    parser.add_argument('--still', help='the library with the clock that stands still')
    parser.add_argument('--compiler', default='cc', help='the one that built povc, for the note beside the counts')
    parser.add_argument('--store', action='store_true', help='write the counts down as those to hold to')
    parser.add_argument('scenes', nargs='*', default=SCENES)
    return parser.parse_args()


def conditions(compiler):
    """What the counts depend on besides the source."""
    version = subprocess.run([compiler, '--version'], stdout=subprocess.PIPE, text=True).stdout.splitlines()
    processor = Path('/proc/cpuinfo')
    flags = re.search(r'^flags\s*:(.*)', processor.read_text(), re.M) if processor.exists() else None
    wide = 'AVX2' if flags and 'avx2' in flags[1].split() else 'no AVX2'
    return f'{version[0] if version else compiler}, {wide}'


def count(povc, still, scene, width, height):
    """Instructions and rays of one run."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / 'callgrind.out'
        clock = ['env', f'LD_PRELOAD={Path(still).resolve()}'] if still else []
        run_of = programs.run([*clock, 'valgrind', '--tool=callgrind', f'--callgrind-out-file={out}', povc, scene, width,
                               height, '/dev/null', '--format', 'pfm', '--threads', 1, '--stats', '--progress', 'none'])
        total = re.search(r'^(?:totals|summary): (\d+)', out.read_text(), re.M)
    if not total:
        raise programs.ProgramError('callgrind wrote no total')
    return int(total[1]), programs.figures(run_of)['rays_total']


def instructions_per_ray(povc, still, scene):
    less, fewer = count(povc, still, scene, *SMALL)
    more, rays = count(povc, still, scene, *LARGE)
    return (more - less) / (rays - fewer)


def read_stored(path):
    """The conditions they were counted under, and the counts by scene."""
    if not Path(path).exists():
        return '', {}
    lines = Path(path).read_text().splitlines()
    noted = next((line[2:] for line in lines if line.startswith('# ')), '')
    return noted, {name: float(value) for name, value in (line.split() for line in lines if line and line[0] != '#')}


def verdict(now, before):
    if before is None:
        return 'not stored', True
    change = now / before - 1.0
    held = abs(change) <= LIMIT
    note = '' if held else '  OVER' if change > 0 else '  UNDER: store the better count'
    return f'{100.0 * change:+.2f} %{note}', held


def main():
    options = arguments()
    if not shutil.which('valgrind'):
        print('bench-counts: skipped, valgrind is not installed')
        return 0
    here = conditions(options.compiler)
    noted, stored = read_stored(options.stored)
    same = noted == here
    if stored and not same and not options.store:
        print(f'Stored under: {noted}\nCounted under: {here}')
        print('Other conditions, so nothing is held to the stored counts.')
    print(f'{"scene":<14}{"instructions a ray":>20}{"stored":>10}  change', flush=True)
    counts, over = {}, []
    for name in options.scenes:
        scene, _ = make_scenes.make(name, Path(options.work) / 'scenes', *LARGE)
        counts[name] = instructions_per_ray(options.povc, options.still, scene)
        said, held = verdict(counts[name], stored.get(name))
        print(f'{name:<14}{counts[name]:20.1f}{stored.get(name, 0.0):10.1f}  {said}', flush=True)
        over += [] if held else [name]
    if options.store:
        stored.update(counts)
        rows = [f'{name} {value:.1f}' for name, value in stored.items()]
        Path(options.stored).write_text('\n'.join([f'# {here}', *rows]) + '\n')
        return 0
    if over and same:
        print(f'Not within {100 * LIMIT:g} %: {", ".join(over)}')
    return 1 if over and same else 0


if __name__ == '__main__':
    sys.exit(main())
