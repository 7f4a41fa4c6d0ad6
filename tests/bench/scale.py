#!/usr/bin/env python3
"""How povc grows with the number of objects: reading, building, memory and time a ray, as a table, CSV and SVG.

Tracing and reading are of one thread; building is timed with one thread and with all. The best of the rounds counts: what
other work takes only ever adds.
"""
import argparse
import csv
import sys
from pathlib import Path

import curves
import make_scenes
import programs

KINDS = ('spheres', 'moved', 'stretched', 'mixed')
FIELDS = ('kind', 'objects', 'text_mb', 'parse_s', 'parse_mb_per_s', 'build_1_s', 'build_all_s', 'memory_mb',
          'bytes_per_object', 'ns_per_ray')
PANELS = (('reading, s', 'parse_s'), ('building, one thread, s', 'build_1_s'), ('memory of the process, MB', 'memory_mb'),
          ('ns a ray', 'ns_per_ray'))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--size', default='400x300')
    parser.add_argument('--runs', type=int, default=3)
    parser.add_argument('--up-to', type=float, default=1e6, help='objects; 1e7 takes gigabytes of text and memory')
    parser.add_argument('--kinds', nargs='*', default=KINDS)
    options = parser.parse_args()
    options.width, options.height = (int(part) for part in options.size.split('x'))
    return options


def counts(up_to):
    count = 100
    while count <= up_to:
        yield count
        count *= 10


def run_of(options, scene, threads):
    words, share = programs.run([options.povc, scene, options.width, options.height, '/dev/null', '--format', 'pfm',
                                 '--stats', '--progress', 'none', *threads])
    return dict(programs.figures((words, share)), share=share)


def measure(options, kind, count):
    scene, _ = make_scenes.make(f'{kind}-{count}', Path(options.work) / 'scenes', options.width, options.height)
    one = [run_of(options, scene, ('--threads', 1)) for _ in range(options.runs)]
    shared = [run_of(options, scene, ()) for _ in range(options.runs)]
    size = scene.stat().st_size
    # A run of one thread that other work held up is corrected by its share of the processor.
    parse, build = (min(run[name] * run['share'] for run in one) for name in ('parse', 'build'))
    memory = 1024 * min(run['memory_peak'] for run in one + shared)
    return {'kind': kind, 'objects': count, 'text_mb': size / 1e6, 'parse_s': parse,
            'parse_mb_per_s': size / 1e6 / parse, 'build_1_s': build,
            'build_all_s': min(run['build'] for run in shared), 'memory_mb': memory / 1e6,
            'bytes_per_object': memory / count,
            'ns_per_ray': min(run['trace'] / run['rays_total'] for run in one) * 1e9}


def draw(rows, kinds):
    panels = [(title, [(kind, [(row['objects'], row[name]) for row in rows if row['kind'] == kind]) for kind in kinds])
              for title, name in PANELS]
    return curves.draw('povtrace by the number of objects', 'objects', panels)


def main():
    options = arguments()
    rows = []
    print(f'{"scene":<18}{"text MB":>9}{"parse s":>9}{"MB/s":>7}{"build 1":>9}{"build all":>10}{"bytes each":>12}{"ns/ray":>8}')
    for kind in options.kinds:
        for count in counts(options.up_to):
            try:
                row = measure(options, kind, count)
            except (programs.ProgramError, ValueError) as error:
                sys.exit(f'bench-scale: {kind}-{count}: {error}')
            rows.append(row)
            print(f'{kind + "-" + str(count):<18}{row["text_mb"]:9.2f}{row["parse_s"]:9.3f}{row["parse_mb_per_s"]:7.0f}'
                  f'{row["build_1_s"]:9.3f}{row["build_all_s"]:10.3f}{row["bytes_per_object"]:12.0f}{row["ns_per_ray"]:8.0f}',
                  flush=True)
    work = Path(options.work)
    with open(work / 'scale.csv', 'w', newline='') as file:
        writer = csv.DictWriter(file, FIELDS)
        writer.writeheader()
        writer.writerows(rows)
    (work / 'scale.svg').write_text(draw(rows, options.kinds))
    print(f'{work / "scale.csv"} and {work / "scale.svg"} hold the same.')


if __name__ == '__main__':
    main()
