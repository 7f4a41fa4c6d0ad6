#!/usr/bin/env python3
"""Times povc with 1, 2, ... threads on the same scenes, in turn: how many times as fast it is, and where the rest went.

`busy` is the threads' processor time by their number and the wall time of tracing: what is missing to 1 they stood idle,
at the start, at the end, or because other work had the processor. `overhead` is by how much the same work cost more
processor time than on one thread: caches and memory that are shared, clocks that fall. `whole` counts the process from
its start to its end with reading, building and writing. Last, what the tiles alone allow for up to 16 threads: tails.c.
"""
import argparse
import csv
import os
import re
import statistics
import sys
import tempfile
import time
from pathlib import Path

import make_scenes
import programs

SCENES = ('flake-4', 'spheres-1e4', 'mixed-1e4', 'hall', 'glass', 'strip', 'spheres-1e6')
FIELDS = ('scene', 'threads', 'trace_s', 'faster', 'busy', 'overhead', 'whole_s', 'whole_faster', 'build_s')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--tails', default='build/bench/tails', help='the program that hands out tiles')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--size', default='800x600')
    parser.add_argument('--runs', type=int, default=5, help='rounds of each scene')
    parser.add_argument('--threads', nargs='*', type=int, help='default: 1 to the number of processors, beyond 4 doubled')
    parser.add_argument('scenes', nargs='*', default=SCENES)
    options = parser.parse_args()
    options.width, options.height = (int(part) for part in options.size.split('x'))
    options.threads = options.threads or default_threads(len(os.sched_getaffinity(0)))
    return options


def default_threads(cores):
    small, large = list(range(1, min(cores, 4) + 1)), 8
    while large < cores:
        small.append(large)
        large *= 2
    return small + ([cores] if cores > 4 else [])


def draw(options, scene, threads, report):
    """One run: seconds of tracing, of the threads' processor, of the build and of the whole."""
    begun = time.perf_counter()
    said = programs.run([options.povc, scene, options.width, options.height, '/dev/null', '--format', 'pfm', '--stats',
                         '--threads', threads, '--progress', 'none', '--report', report])
    whole = time.perf_counter() - begun
    found = programs.figures((said[0], 1.0))
    with open(report) as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith('#')))
    return {'trace': found['trace'], 'cpu': float(rows[-1]['cpu_s']), 'build': found['build'], 'whole': whole}


def measure(options, name, scene):
    """Rows for each number of threads, the first being the measure."""
    rounds = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(options.runs):
            rounds.append([draw(options, scene, threads, Path(folder) / 'report.csv') for threads in options.threads])

    def middle(figure):
        return statistics.median(figure(one) for one in rounds)
    for place, threads in enumerate(options.threads):
        yield {'scene': name, 'threads': threads,
               'trace_s': middle(lambda one: one[place]['trace']),
               'faster': middle(lambda one: one[0]['trace'] / one[place]['trace']),
               'busy': middle(lambda one: one[place]['cpu'] / one[place]['trace'] / threads),
               'overhead': middle(lambda one: one[place]['cpu'] / one[0]['cpu']),
               'whole_s': middle(lambda one: one[place]['whole']),
               'whole_faster': middle(lambda one: one[0]['whole'] / one[place]['whole']),
               'build_s': middle(lambda one: one[place]['build'])}


def print_tails(options, name, scene):
    said, _ = programs.run([options.tails, scene, options.width, options.height])
    bounds = re.findall(r'threads: (\d+) .*faster: ([\d.]+)', said)
    print(f'{name:<14}  tiles allow {", ".join(f"{faster} on {threads}" for threads, faster in bounds[1:])}', flush=True)


def main():
    options = arguments()
    rows = []
    print(f'{"scene":<14}{"threads":>8}{"trace ms":>10}{"faster":>8}{"busy":>7}{"overhead":>9}{"whole ms":>10}{"faster":>8}')
    for name in options.scenes:
        try:
            scene, _ = make_scenes.make(name, Path(options.work) / 'scenes', options.width, options.height)
        except ValueError as error:
            sys.exit(f'bench-threads: {error}')
        for row in measure(options, name, scene):
            rows.append(row)
            print(f'{row["scene"]:<14}{row["threads"]:>8}{1e3 * row["trace_s"]:10.1f}{row["faster"]:8.2f}{row["busy"]:7.2f}'
                  f'{row["overhead"]:9.2f}{1e3 * row["whole_s"]:10.1f}{row["whole_faster"]:8.2f}', flush=True)
        if Path(options.tails).exists():
            print_tails(options, name, scene)
    for threads in options.threads[1:]:
        mine = [row['faster'] for row in rows if row['threads'] == threads]
        print(f'{threads} threads: {statistics.median(mine):.2f} times as fast in the median, {min(mine):.2f} at least')
    with open(Path(options.work) / 'threads.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)


if __name__ == '__main__':
    main()
