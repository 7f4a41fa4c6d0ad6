#!/usr/bin/env python3
"""Times povc, POV-Ray, Tachyon and Embree on the same rays, in turn, and prints their ratios.

Each round runs every program once on a scene, so that a busy machine is busy for all of them; what counts is the median
over the rounds of each round's ratio. The pictures are held against each other before.
"""
import argparse
import csv
import statistics
import sys
from pathlib import Path

import pictures

import chart
import make_scenes
import programs
import scenes

# Of the slowest round to the fastest; other work on the machine shows as more.
STEADY = 1.15
QUICK = ('flake-3', 'spheres-1e2', 'spheres-1e4', 'mixed-1e2', 'rings', 'hall')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--povray', default='povray')
    parser.add_argument('--tachyon', default='tachyon')
    parser.add_argument('--embree', default='build/bench/embree_spheres')
    parser.add_argument('--work', default='build/bench', help='where scenes, pictures and results go')
    parser.add_argument('--scenes', nargs='*', help='default: ' + ' '.join(scenes.BENCH))
    parser.add_argument('--runs', type=int, default=5, help='rounds of each scene')
    parser.add_argument('--size', default='800x600')
    parser.add_argument('--quick', action='store_true', help='small pictures of a few scenes, three rounds')
    parser.add_argument('--without', nargs='*', default=[], help='programs to leave out, by the name in the table')
    parser.add_argument('--base', default='povtrace', help='the program that the others are held against')
    parser.add_argument('--no-pictures', action='store_true', help='do not compare the pictures first')
    options = parser.parse_args()
    if options.quick:
        options.size, options.runs = '320x240', 3
    options.scenes = options.scenes or (QUICK if options.quick else scenes.BENCH)
    options.width, options.height = (int(part) for part in options.size.split('x'))
    return options


def chosen_programs(options):
    """Those that are there, the base first; what is missing is said."""
    every = [programs.Povtrace(options.povc), programs.PovRay(options.povray), programs.Tachyon(options.tachyon),
             programs.Embree(options.embree), programs.Embree(options.embree, 8), programs.Embree(options.embree, 16)]
    wanted = [program for program in every if program.name not in options.without]
    for program in wanted:
        if not program.is_there():
            print(f'{program.name} is left out: there is no {program.path}')
    there = [program for program in wanted if program.is_there()]
    if not there:
        sys.exit('bench: none of the programs is there')
    return sorted(there, key=lambda program: program.name != options.base)


def compare_pictures(job, drawers, folder):
    """Per cent of the pixels in which each program's picture is off the first program's."""
    folder.mkdir(parents=True, exist_ok=True)
    off, first = {}, None
    for program in drawers:
        picture = folder / f'{job.name}-{program.name.replace(" ", "-")}.{program.ending}'
        program.draw(job, picture)
        if first:
            off[program.name] = pictures.off_percent(first, picture)
        first = first or picture
    return off


def measure(job, drawers, runs):
    """Figures of each program, one of each round."""
    rounds = {program.name: [] for program in drawers}
    for _ in range(runs):
        for program in drawers:
            rounds[program.name].append(program.draw(job))
    return rounds


def summary(job, drawers, rounds, off):
    """A row for each program."""
    base = [one['trace'] for one in rounds[drawers[0].name]]
    rays = next((runs[0]['rays_total'] for runs in rounds.values() if 'rays_total' in runs[0]), None)
    for program in drawers:
        times = [one['trace'] for one in rounds[program.name]]
        median = statistics.median(times)
        yield {'scene': job.name, 'program': program.name, 'runs': len(times), 'trace_median_s': median,
               'trace_min_s': min(times), 'trace_max_s': max(times),
               'ns_per_ray': median * 1e9 / rays if rays else '',
               'base': drawers[0].name,
               'ratio': statistics.median(time / one for time, one in zip(times, base)),
               'ratio_of_minima': min(times) / min(base),
               'pixels_off_percent': off.get(program.name, '')}


def bench_scene(name, every, options):
    work = Path(options.work)
    povray, tachyon = make_scenes.make(name, work / 'scenes', options.width, options.height)
    job = programs.Job(name, povray, tachyon, options.width, options.height, name.partition('-')[0] == 'mesh')
    drawers = [program for program in every if program.can_draw(job)]
    off = {} if options.no_pictures else compare_pictures(job, drawers, work / 'pictures')
    return list(summary(job, drawers, measure(job, drawers, options.runs), off))


def print_head(every):
    print(f'Times {every[0].name}\'s trace time (medians of paired rounds); in brackets, per cent of pixels off by more '
          f'than 2/255.')
    print(f'{"scene":<13}{every[0].name + " ms":>13}{"ns/ray":>8}' +
          ''.join(f'{program.name:>18}' for program in every[1:]), flush=True)


def print_rows(rows, every):
    by_name = {row['program']: row for row in rows}
    first = rows[0]
    line = f'{first["scene"]:<13}{first["trace_median_s"] * 1e3:13.1f}'
    line += f'{first["ns_per_ray"]:8.1f}' if first['ns_per_ray'] else ' ' * 8
    if first['base'] != every[0].name:
        line += f'  by {first["base"]}'
    for program in every[1:]:
        row = by_name.get(program.name)
        off = f' ({row["pixels_off_percent"]:.2f})' if row and row['pixels_off_percent'] != '' else ''
        line += f'{row["ratio"]:.2f}{off}'.rjust(18) if row else '-'.rjust(18)
    print(line, flush=True)


def print_medians(rows, every):
    """The last lines: each program's ratio in the median of its scenes and its least; how steady the times were."""
    for program in every[1:]:
        ratios = [row['ratio'] for row in rows if row['program'] == program.name and row['base'] == every[0].name]
        if ratios:
            print(f'{program.name}: {statistics.median(ratios):.2f} in the median, {min(ratios):.2f} at least')
    spread = statistics.median(row['trace_max_s'] / row['trace_min_s'] for row in rows)
    print(f'The slowest round took {spread:.2f} times the fastest in the median: '
          f'{"steady" if spread < STEADY else "the machine was busy, measure again"}.')


def write_results(rows, every, options):
    work = Path(options.work)
    with open(work / 'bench.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)
    drawn = [(name, {row['program']: row['ratio'] for row in rows if row['scene'] == name}) for name in options.scenes]
    drawn = [(name, ratios) for name, ratios in drawn if ratios]
    title = f'The same rays, {options.size}, one thread'
    (work / 'bench.svg').write_text(chart.draw(title, [program.name for program in every], drawn))
    print(f'{work / "bench.csv"} and {work / "bench.svg"} hold the same.')


def main():
    options = arguments()
    every = chosen_programs(options)
    rows, failed = [], []
    print_head(every)
    for name in options.scenes:
        try:
            mine = bench_scene(name, every, options)
        except (programs.ProgramError, pictures.images.PictureError, ValueError) as error:
            print(f'{name:<13} FAILED: {error}', flush=True)
            failed.append(name)
            continue
        print_rows(mine, every)
        rows += mine
    if rows:
        print_medians(rows, every)
        write_results(rows, every, options)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
