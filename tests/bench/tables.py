#!/usr/bin/env python3
"""Fill the tables of docs/performance.md and of the notebook behind it from what the bench measured.

A table stands between `<!-- bench:NAME -->` and `<!-- end -->`; each NAME comes from its CSV in the bench's folder. Where
there is none, the table stays as it is.
"""
import argparse
import csv
import os
import re
import statistics
import subprocess
import time
from pathlib import Path

# How many times as long as ours each of the others is to take.
ASKED = {'POV-Ray': 5.0, 'Tachyon': 1.8, 'Embree': 1.35, 'Embree x8': 1.15, 'Embree x16': 1.15}
PAGES = ('docs/performance.md', 'docs/notes/where-time-goes.md')
PARTS = ('tree', 'filters', 'shapes', 'instances', 'normals', 'shading', 'picture')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--work', default='build/bench', help='where the CSV files are')
    parser.add_argument('--docs', nargs='+', default=PAGES)
    return parser.parse_args()


def table(head, rows):
    lines = ['| ' + ' | '.join(head) + ' |', '|---' * len(head) + '|']
    return lines + ['| ' + ' | '.join(str(cell) for cell in row) + ' |' for row in rows]


def by_scene(rows):
    """Rows of the same scene together, in their order."""
    scenes = {}
    for row in rows:
        scenes.setdefault(row['scene'], []).append(row)
    return scenes


def aimed_at(ours, mine):
    """Nanoseconds a ray that the hardest of the demands leaves."""
    return min(float(mine[name]['ratio']) / asked for name, asked in ASKED.items() if name in mine) * ours


def figures(rows):
    """The table of times, and what it comes to for each peer."""
    lines, ratios = [], {name: [] for name in ASKED}
    for scene, mine in by_scene(rows).items():
        mine = {row['program']: row for row in mine}
        ours = mine.get('povtrace')
        if not ours or ours['base'] != 'povtrace':
            continue
        cells = []
        for name in ASKED:
            cells.append(f'{float(mine[name]["ratio"]):.2f}' if name in mine else '-')
            ratios[name] += [float(mine[name]['ratio'])] if name in mine else []
        per_ray = float(ours['ns_per_ray'])
        peers = [name for name in ASKED if name in mine]
        lines.append((scene, f'{1e3 * float(ours["trace_median_s"]):.0f}', f'{per_ray:.0f}', *cells,
                      f'{aimed_at(per_ray, mine):.0f}' if peers else '-'))
    for words, of in (('in the median', statistics.median), ('at least', min)):
        lines.append((words, '', '', *(f'{of(ratios[name]):.2f}' if ratios[name] else '-' for name in ASKED), ''))
    lines.append(('asked on each', '', '', *(f'{asked:g}' for asked in ASKED.values()), ''))
    return table(('scene', 'povtrace ms', 'ns/ray', 'POV-Ray', 'Tachyon', 'Embree', 'its packets of 8', 'of 16',
                  'ns/ray aimed at'), lines)


def whole(rows):
    lines = []
    for threads, words in (('1', 'one each'), ('shipped', 'as shipped')):
        mine = [row for row in rows if row['threads'] == threads]
        wall, cpu = ([float(row[kind]) for row in mine] for kind in ('ratio', 'cpu_ratio'))
        least = min(mine, key=lambda row: float(row['ratio']))
        lines.append((words, len(mine), f'{statistics.median(float(row["povtrace_ms"]) for row in mine):.1f}',
                      f'{statistics.median(float(row["povray_ms"]) for row in mine):.0f}', f'{statistics.median(wall):.1f}',
                      f'{min(wall):.1f} ({least["scene"]})', f'{statistics.median(cpu):.1f}', f'{min(cpu):.1f}'))
    return table(('threads', 'scenes', 'povc ms', 'POV-Ray ms', 'times as fast, median', 'least', 'in processor time, median',
                  'least'), lines)


def threads(rows):
    return table(('scene', 'threads', 'ms', 'times as fast', 'threads busy', 'overhead', 'whole process'),
                 [(row['scene'], row['threads'], f'{1e3 * float(row["trace_s"]):.0f}', f'{float(row["faster"]):.2f}',
                   f'{100 * float(row["busy"]):.0f} %', f'{100 * float(row["overhead"]) - 100:.0f} %',
                   f'{float(row["whole_faster"]):.2f}') for row in rows])


def scale(rows):
    return table(('scene', 'text MB', 'MB/s read', 'build s, 1 thread', 'all', 'memory MB', 'bytes an object', 'ns/ray'),
                 [(f'{row["kind"]}-{float(row["objects"]):.0e}'.replace('e+0', 'e'), f'{float(row["text_mb"]):.2f}',
                   f'{float(row["parse_mb_per_s"]):.0f}', f'{float(row["build_1_s"]):.3f}',
                   f'{float(row["build_all_s"]):.3f}', f'{float(row["memory_mb"]):.0f}',
                   f'{float(row["bytes_per_object"]):.0f}', f'{float(row["ns_per_ray"]):.0f}')
                  for row in rows if float(row['objects']) >= 1e5])


def where(rows):
    return table(('scene', 'all', 'tree and traversal', 'block filters', 'exact shapes', 'instances', 'normals', 'shading',
                  'picture', 'near misses', 'far misses', 'branches missed'),
                 [(row['scene'], f'{float(row["all"]):.0f}', *(f'{float(row[part]):.0f}' for part in PARTS),
                   *(f'{float(row[miss]):.1f}' for miss in ('near_misses', 'far_misses', 'branch_misses')))
                  for row in rows])


TABLES = {'figures': ('bench.csv', figures), 'whole': ('whole.csv', whole), 'threads': ('threads.csv', threads),
          'scale': ('scale.csv', scale), 'where': ('where.csv', where)}


def conditions(path):
    """The line below a table: when it was measured, on what, and the last commit before."""
    day = time.strftime('%Y-%m-%d', time.localtime(path.stat().st_mtime))
    commit = subprocess.run(['git', 'log', '-1', '--format=%s', f'--before={int(path.stat().st_mtime)}'],
                            stdout=subprocess.PIPE, text=True).stdout.strip()
    cpuinfo = Path('/proc/cpuinfo')
    model = re.search(r'model name\s*: (.*)', cpuinfo.read_text()) if cpuinfo.exists() else None
    return (f'Measured on {day} after "{commit}", {model[1] if model else "an unknown processor"}, '
            f'{len(os.sched_getaffinity(0))} cores.')


def main():
    options = arguments()
    pages = {path: path.read_text() for path in map(Path, options.docs)}
    for name, (source, make) in TABLES.items():
        path = Path(options.work) / source
        if not path.exists():
            print(f'{name}: left as it is, there is no {path}')
            continue
        with open(path) as file:
            lines = make(list(csv.DictReader(file))) + ['', conditions(path)]
        mark = f'<!-- bench:{name} -->'
        filled = 0
        for page, text in pages.items():
            pages[page], found = re.subn(f'({mark}\n).*?(<!-- end -->)', lambda m: m[1] + '\n'.join(lines) + '\n' + m[2],
                                         text, flags=re.S)
            filled += found
        print(f'{name}: {"filled from " + str(path) if filled else "no mark " + mark + " in " + " ".join(options.docs)}')
    for page, text in pages.items():
        page.write_text(text)


if __name__ == '__main__':
    main()
