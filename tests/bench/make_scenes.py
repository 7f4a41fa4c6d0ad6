#!/usr/bin/env python3
"""Writes the scenes of the bench: NAME.pov, and NAME.dat for Tachyon where there are only spheres."""
import argparse
import os
import sys
from pathlib import Path

import formats
import scenes

HERE = Path(__file__).resolve().parent
SOURCES = ('make_scenes.py', 'scenes.py', 'shapes.py', 'solids.py', 'formats.py', 'geometry.py')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--out', default='build/bench/scenes', help='folder to write to')
    parser.add_argument('--size', default='800x600', help='of the picture; Tachyon\'s file depends on it')
    parser.add_argument('--force', action='store_true', help='write again what is there already')
    parser.add_argument('names', nargs='*', default=scenes.BENCH, help='default: ' + ' '.join(scenes.BENCH))
    return parser.parse_args()


def is_fresh(path):
    newest = max((HERE / name).stat().st_mtime for name in SOURCES)
    return path.exists() and path.stat().st_mtime > newest


def write_whole(path, write):
    """The file is there when all of it is."""
    part = path.with_name(path.name + '.part')
    with open(part, 'w', buffering=1 << 20) as file:
        write(file)
    os.replace(part, path)


def make(name, folder, width, height, force=False):
    """Both files of a scene, or the names of those that are there already: (.pov, .dat or None)."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    scene = scenes.scene(name)
    povray, tachyon = folder / f'{name}.pov', folder / f'{name}-{width}x{height}.dat'
    if force or not is_fresh(povray):
        write_whole(povray, lambda file: formats.write_povray(file, scene))
    if not scene.spheres:
        return povray, None
    if force or not is_fresh(tachyon):
        write_whole(tachyon, lambda file: formats.write_tachyon(file, scene, width, height))
    return povray, tachyon


def main():
    options = arguments()
    width, height = (int(part) for part in options.size.split('x'))
    for name in options.names:
        try:
            for path in make(name, options.out, width, height, options.force):
                if path:
                    print(f'{path}: {path.stat().st_size / 1e6:.2f} MB')
        except ValueError as error:
            sys.exit(f'make_scenes: {error}')


if __name__ == '__main__':
    main()
