#!/usr/bin/env python3
"""Holds povc's pictures of small bench scenes together, byte for byte.

The first is traced without a tree by one thread of the baseline library; against it stand tree and list, by several
numbers of threads, of each copy of the library: for any x86-64, for x86-64-v3 and v4, and one made of portable C alone.
"""
import argparse
import os
import sys
from itertools import product
from pathlib import Path

import make_scenes
import programs

SCENES = ('flake-2', 'spheres-1e2', 'spheres-1e3', 'mixed-1e2', 'mixed-600', 'rings-3', 'tree-5', 'hall', 'glass-3',
          'strip-400', 'moved-300', 'stretched-300')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--portable', help='a povc built of portable C alone')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--size', default='120x90')
    parser.add_argument('--threads', nargs='*', type=int, default=(1, 2, 3, 8))
    parser.add_argument('scenes', nargs='*', default=SCENES)
    options = parser.parse_args()
    options.width, options.height = (int(part) for part in options.size.split('x'))
    return options


def narrow_folder(work, povc):
    """A folder with the baseline library alone: where the loader looks there first, it finds no other."""
    folder = work / 'narrow'
    folder.mkdir(exist_ok=True)
    library = 'libpovtrace.so.0'
    if not (folder / library).is_symlink():
        (folder / library).symlink_to((povc.parent.parent / 'lib' / library).resolve())
    return folder


def copies(options, work):
    """Name, program and the loader's first folder of each copy of the library that runs here."""
    povc = Path(options.povc).resolve()
    found = [('baseline', povc, str(narrow_folder(work, povc)))]
    os.environ.pop('LD_LIBRARY_PATH', None)
    said, _ = programs.run([povc, '--version'])
    for copy in ('x86-64-v3', 'x86-64-v4'):
        folder = povc.parent.parent / 'lib' / 'glibc-hwcaps' / copy
        # The loader took the widest that this processor can run.
        if folder.is_dir() and any(f', {wider})' in said for wider in ('x86-64-v3', 'x86-64-v4') if wider >= copy):
            found.append((copy, povc, str(folder)))
        else:
            print(f'{copy} is left out: it was not built, or this processor is older')
    if options.portable:
        found.append(('portable', Path(options.portable).resolve(), ''))
    return found


def picture(copy, scene, options, accel, threads, out):
    name, povc, first = copy
    os.environ['LD_LIBRARY_PATH'] = first
    said, _ = programs.run([povc, scene, options.width, options.height, out, '--accel', accel, '--threads', threads,
                            '--progress', 'none', '--stats'])
    if name != 'portable' and f'built_for: {name}' not in said:
        raise programs.ProgramError(f'{povc} did not run the {name} library')
    return out.read_bytes()


def main():
    options = arguments()
    work = Path(options.work)
    work.mkdir(parents=True, exist_ok=True)
    every, out, wrong = copies(options, work), work / 'bits.pfm', 0
    for name in options.scenes:
        scene, _ = make_scenes.make(name, work / 'scenes', options.width, options.height)
        first = picture(every[0], scene, options, 'none', 1, out)
        off = [f'{copy[0]}, {accel}, {threads} threads'
               for copy, accel, threads in product(every, ('tree', 'none'), options.threads)
               if picture(copy, scene, options, accel, threads, out) != first]
        print(f'{name:<14} {"the same" if not off else "DIFFERENT: " + "; ".join(off)}', flush=True)
        wrong += len(off)
    pictures = len(options.scenes) * len(every) * 2 * len(options.threads)
    print(f'{pictures} pictures of {len(options.scenes)} scenes by {", ".join(copy[0] for copy in every)}: {wrong} differ')
    return 1 if wrong else 0


if __name__ == '__main__':
    sys.exit(main())
