#!/usr/bin/env python3
"""What certainty costs: whole renders by povc with our primitives, against the same program with textbook kernels.

    cost.py --povc POVC --textbook FOLDER --product FOLDER [--rounds N] [--size W H] [--instructions] [--csv FILE]
            [--document FILE] SCENE...

Both are run in turn, with one thread and one sample a pixel. What counts is the processor's time for tracing, as `--stats`
tells it, corrected for what else the machine did meanwhile; of each pair of runs the ratio, of the ratios the median. With
--instructions callgrind counts instructions instead: once each, and no noise. The pictures may differ a little; how many
pixels do by more than 2/255 is printed besides. --document FILE refreshes the table there between two marks.
"""
import argparse
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time


def render(options, folders, scene, picture):
    """Seconds of tracing on a processor of its own."""
    command = [options.povc, scene, *map(str, options.size), picture, '-t', '1', '--spp', '1', '--stats', '--quiet',
               '--plugin-path', ':'.join(folders)]
    begun = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    words = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    share = min(1.0, (used.ru_utime + used.ru_stime) / (time.monotonic() - begun))
    found = re.search(r'^trace: ([\d.]+) s', words, re.M)
    if process.returncode != 0 or not found:
        sys.exit(f'cost: {" ".join(map(str, command))}: {words.strip()}')
    return float(found[1]) * share


def instructions(options, folders, scene, picture):
    """Instructions of whatever a worker does, by callgrind."""
    with tempfile.NamedTemporaryFile() as out:
        command = ['valgrind', '--tool=callgrind', f'--callgrind-out-file={out.name}', '--toggle-collect=worker_trace',
                   options.povc, scene, *map(str, options.size), picture, '-t', '1', '--spp', '1', '--quiet',
                   '--plugin-path', ':'.join(folders)]
        subprocess.run(command, check=True, capture_output=True)
        text = pathlib.Path(out.name).read_text()
    return int(re.search(r'^(?:totals|summary): (\d+)', text, re.M)[1])


def pixels(path):
    """The bytes of a PPM after its three words of header."""
    header = re.match(rb'P6\s+\d+\s+\d+\s+\d+\s', path.read_bytes())
    return path.read_bytes()[header.end():]


def differing(a, b):
    """How many pixels differ by more than 2/255, and how many there are."""
    a, b = pixels(a), pixels(b)
    many = sum(any(abs(a[i + c] - b[i + c]) > 2 for c in range(3)) for i in range(0, len(a), 3))
    return many, len(a) // 3


MARKS = ('<!-- cost: begin -->\n', '<!-- cost: end -->\n')


def refresh(options, rows):
    """The table in the document."""
    path = pathlib.Path(options.document)
    text = path.read_text(encoding='utf-8')
    begin, end = (text.index(mark) for mark in MARKS)
    unit = 'million instructions' if options.instructions else 'ms'
    lines = [f'| scene, {options.size[0]}x{options.size[1]} | povtrace, {unit} | textbook kernels | ratio | pixels off by more than 2/255 |',
             '|---|---|---|---|---|']
    scale = 1e-6 if options.instructions else 1e3
    lines += [f'| {name} | {mine * scale:.0f} | {other * scale:.0f} | {ratio:.2f} | {many} |'
              for name, mine, other, ratio, many, _ in rows]
    lines.append(f'| median | | | {statistics.median(row[3] for row in rows):.2f} | |')
    path.write_text(text[:begin + len(MARKS[0])] + '\n'.join(lines) + '\n' + text[end:], encoding='utf-8')


def compare(options, scene, folder):
    """The ratios of the pairs, and our and the textbook's median."""
    ours, theirs = [options.product], [options.textbook, options.product]
    measure, rounds = (instructions, 1) if options.instructions else (render, options.rounds)
    mine, other = [], []
    for number in range(rounds):
        # Who begins takes turns, so that a machine that grows slower favours neither.
        for who in ((0, 1), (1, 0))[number % 2]:
            (mine, other)[who].append(measure(options, (ours, theirs)[who], scene, folder / f'{who}.ppm'))
    ratios = [a / b for a, b in zip(mine, other)]
    return ratios, statistics.median(mine), statistics.median(other)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', required=True)
    parser.add_argument('--product', required=True)
    parser.add_argument('--textbook', required=True)
    parser.add_argument('--rounds', type=int, default=5)
    parser.add_argument('--size', type=int, nargs=2, default=(400, 300))
    parser.add_argument('--instructions', action='store_true')
    parser.add_argument('--csv')
    parser.add_argument('--document')
    parser.add_argument('scenes', nargs='+')
    options = parser.parse_args()
    rows = []
    unit, scale = ('instructions, millions', 1e-6) if options.instructions else ('ms', 1e3)
    print(f'{"scene":16} {"ours":>9} {"textbook":>9} {"ratio":>6}  {"of the pairs":13} pixels that differ   ({unit})')
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for scene in options.scenes:
            ratios, mine, other = compare(options, scene, folder)
            many, of = differing(folder / '0.ppm', folder / '1.ppm')
            name, ratio = pathlib.Path(scene).stem, statistics.median(ratios)
            rows.append((name, mine, other, ratio, many, of))
            print(f'{name:16} {mine * scale:9.1f} {other * scale:9.1f} {ratio:6.3f}  {min(ratios):.3f}..{max(ratios):.3f}  '
                  f'{many} of {of}', flush=True)
    print(f'median ratio {statistics.median(row[3] for row in rows):.3f}, '
          f'largest {max(row[3] for row in rows):.3f}')
    if options.document:
        refresh(options, rows)
    if options.csv:
        with open(options.csv, 'w', encoding='utf-8') as out:
            out.write('scene,ours,textbook,ratio,pixels_differing,pixels\n')
            out.writelines(','.join(map(str, row)) + '\n' for row in rows)


if __name__ == '__main__':
    main()
