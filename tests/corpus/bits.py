#!/usr/bin/env python3
"""The scenes that come with POV-Ray, each drawn in every way that must give the same bits: on 1, 2 and 8 threads, with the tree
and without, and with each copy of the library that this processor runs.

A scene fails where povc crashes, does not end, says what a sanitizer says, or where a picture is another one. With --once it is
drawn on two threads alone, which is what a build with sanitizers is for. Written is bits.csv: scene, what was found, seconds.
"""
import argparse
import csv
import os
import signal
import subprocess
import sys
from pathlib import Path

from corpus import FOLDERS, Run, all_scenes

REPORTS = ('Sanitizer', 'runtime error:')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--povc', type=Path, default=Path('build/bin/povc'))
    parser.add_argument('--scenes', help=f'folder of scenes (default: one of {", ".join(FOLDERS)})')
    parser.add_argument('--work', type=Path, default=Path('build/corpus'))
    parser.add_argument('--size', default='64x48')
    parser.add_argument('--timeout', type=float, default=120.0, help='seconds for each picture')
    parser.add_argument('--only', default='', help='scenes whose path holds this')
    parser.add_argument('--part', default='1/1', help='I/N: every N-th scene, from the I-th on')
    parser.add_argument('--once', action='store_true', help='one picture a scene, on two threads')
    return parser.parse_args()


def copies(options):
    """By name, the folder that makes the loader take that copy of the library; the widest is what it takes by itself."""
    lib = options.povc.resolve().parent.parent / 'lib'
    narrow = options.work / 'narrow'
    narrow.mkdir(parents=True, exist_ok=True)
    link = narrow / 'libpovtrace.so.0'
    link.unlink(missing_ok=True)
    link.symlink_to(lib / 'libpovtrace.so.0')
    folders = {'baseline': narrow.resolve()}
    for folder in sorted(lib.glob('glibc-hwcaps/*')):
        said = subprocess.run([options.povc, '--version'], env=dict(os.environ, LD_LIBRARY_PATH=str(folder)), text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        if said.returncode == 0:
            folders[folder.name.replace('x86-64-', '')] = folder
    return folders


def ways(options):
    """Name, words of the command line and copy of each further picture of a scene."""
    if options.once:
        return []
    rest = [(f'{n} threads', ['-t', str(n)], None) for n in (2, 8)] + [('no tree', ['-t', '1', '--accel', 'none'], None)]
    return rest + [(name, ['-t', '1'], folder) for name, folder in copies(options).items()]


def draw(options, scene, words, copy, picture):
    """What went wrong, or nothing, and the seconds of processor time. An error of the scene is no failure; that it is the same one
    is not asked."""
    width, height = options.size.split('x')
    command = [str(options.povc.resolve()), scene.name, width, height, str(picture.resolve()), '-q', *words]
    picture.unlink(missing_ok=True)
    if copy:
        command = ['env', f'LD_LIBRARY_PATH={copy}', *command]
    run = Run(command, scene.parent, options.timeout)
    if run.status is None:
        return 'late', run.cpu
    if any(word in run.said for word in REPORTS):
        return 'report: ' + next(line for line in run.said.splitlines() if any(word in line for word in REPORTS)), run.cpu
    # GNU time says 128 and the number of a signal.
    if run.status < 0 or run.status > 128:
        return f'ended by {signal.Signals(abs(run.status) % 128).name}', run.cpu
    return ('' if run.status in (0, 1, 3) else f'status {run.status}'), run.cpu


def judge(options, scene, others):
    first, second = options.work / 'first.pfm', options.work / 'second.pfm'
    found, seconds = draw(options, scene, ['-t', '2' if options.once else '1'], None, first)
    if found:
        return found, seconds
    differ = []
    for name, words, copy in others:
        wrong, more = draw(options, scene, words, copy, second)
        seconds += more
        if wrong:
            differ.append(f'{name}: {wrong}')
        elif first.exists() != second.exists() or (first.exists() and first.read_bytes() != second.read_bytes()):
            differ.append(f'{name}: other bits')
    return '; '.join(differ) or ('same' if first.exists() else 'not read'), seconds


def main():
    options = arguments()
    options.work.mkdir(parents=True, exist_ok=True)
    folder, scenes = all_scenes(options)
    index, count = map(int, options.part.split('/'))
    failed, read, refused, late = 0, 0, 0, 0
    with open(options.work / 'bits.csv', 'w', newline='') as file:
        rows = csv.writer(file)
        rows.writerow(('scene', 'found', 'seconds'))
        for scene in scenes[index - 1::count]:
            found, seconds = judge(options, scene, ways(options))
            rows.writerow((scene.relative_to(folder), found, f'{seconds:.2f}'))
            file.flush()
            read += found == 'same'
            refused += found == 'not read'
            slow = found and all(part.endswith('late') for part in found.split('; '))
            late += slow
            if found not in ('same', 'not read'):
                failed += not slow
                print(f'{scene.relative_to(folder)}: {found}', flush=True)
    print(f'{len(scenes[index - 1::count])} scenes: {read} drawn, the same in every way; {refused} not read; {late} late; {failed} failed')
    return failed > 0 or read == 0   # a povc that does not run draws none


if __name__ == '__main__':
    sys.exit(main())
