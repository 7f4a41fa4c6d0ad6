#!/usr/bin/env python3
"""Times whole processes, from their start to the finished PNG: povc against POV-Ray on the small scenes of the tests.

Start-up counts here more than tracing. Each round runs all on a scene in turn, once with one thread for each program and
once with as many as each takes by itself. POV-Ray sleeps for about half a second in every run, so its processor time is
held against ours besides: that ratio is what its work alone takes.
"""
import argparse
import csv
import os
import statistics
import sys
import time
from pathlib import Path

import pictures

import programs

sys.dont_write_bytecode = True
import compare

ROOT = Path(__file__).resolve().parents[2]
FIELDS = ('scene', 'threads', 'povtrace_ms', 'povray_ms', 'ratio', 'povtrace_cpu_ms', 'povray_cpu_ms', 'cpu_ratio')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--povray', default='povray')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--size', default='320x240', help='of the pictures, as in make compare')
    parser.add_argument('--runs', type=int, default=3, help='rounds of each scene')
    parser.add_argument('scenes', nargs='*', help='default: all of scenes/test')
    options = parser.parse_args()
    options.width, options.height = options.size.split('x')
    return options


def timed(command):
    """Seconds of wall and of processor of a process that must succeed; what it says is thrown away."""
    null = os.open(os.devnull, os.O_RDWR)
    actions = [(os.POSIX_SPAWN_DUP2, null, number) for number in (0, 1, 2)]
    surroundings = dict(os.environ, HOME='/nonexistent')
    begun = time.perf_counter()
    process = os.posix_spawnp(command[0], [str(word) for word in command], surroundings, file_actions=actions)
    _, status, used = os.wait4(process, 0)
    wall = time.perf_counter() - begun
    os.close(null)
    if status != 0:
        raise programs.ProgramError(f'{" ".join(str(word) for word in command)}: failed')
    return wall, used.ru_utime + used.ru_stime


def commands(scene, source, options, threads):
    """povc's and POV-Ray's command line; `threads` is 1 or None for what each takes by itself."""
    picture = Path(options.work) / 'whole.png'
    ours = [options.povc, scene, options.width, options.height, picture, '--quiet']
    theirs = [options.povray, f'+I{source}', f'+O{picture}', f'+W{options.width}', f'+H{options.height}', '-A', '-D', '-V']
    if threads:
        return ours + ['--threads', threads], theirs + [f'+WT{threads}']
    return ours, theirs


def measure(scene, options):
    """Rows of the scene: one thread each, and as shipped."""
    source = Path(options.work) / 'whole.pov'
    source.write_bytes(compare.povray_source(scene))
    for threads in (1, None):
        pair = commands(scene, source, options, threads)
        rounds = [[timed(command) for command in pair] for _ in range(options.runs)]
        wall, cpu = ([[one[kind] for one in both] for both in rounds] for kind in (0, 1))
        row = {'scene': scene.stem, 'threads': threads or 'shipped'}
        for name, figures, suffix in (('', wall, ''), ('cpu_', cpu, 'cpu_')):
            ours, theirs = (statistics.median(one[who] for one in figures) for who in (0, 1))
            row[f'povtrace_{suffix}ms'], row[f'povray_{suffix}ms'] = 1e3 * ours, 1e3 * theirs
            row[f'{name}ratio'] = statistics.median(one[1] / one[0] for one in figures)
        yield row


def print_summary(rows):
    for threads, words in ((1, 'one thread each'), ('shipped', 'threads as shipped')):
        mine = [row for row in rows if row['threads'] == threads]
        wall, cpu = ([row[kind] for row in mine] for kind in ('ratio', 'cpu_ratio'))
        print(f'{words}: wall {statistics.median(wall):.1f} in the median, {min(wall):.1f} at least; '
              f'processor {statistics.median(cpu):.1f} in the median, {min(cpu):.1f} at least')


def main():
    options = arguments()
    Path(options.work).mkdir(parents=True, exist_ok=True)
    scenes = [Path(scene) for scene in options.scenes] or sorted((ROOT / 'scenes' / 'test').glob('*.pov'))
    rows = []
    print(f'{"scene":<36}{"threads":>9}{"ours ms":>9}{"POV-Ray ms":>12}{"ratio":>8}{"of cpu":>8}')
    for scene in scenes:
        for row in measure(scene, options):
            rows.append(row)
            print(f'{row["scene"]:<36}{row["threads"]:>9}{row["povtrace_ms"]:9.1f}{row["povray_ms"]:12.1f}'
                  f'{row["ratio"]:8.1f}{row["cpu_ratio"]:8.1f}', flush=True)
    print_summary(rows)
    with open(Path(options.work) / 'whole.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)


if __name__ == '__main__':
    main()
