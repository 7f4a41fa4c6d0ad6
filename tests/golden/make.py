#!/usr/bin/env python3
"""Draws the golden pictures once more, with POV-Ray (`povray -D`): python3 tests/golden/make.py. They are what
test_golden.c holds povtrace's pictures against. What POV-Ray is given for a scene of the course dialect, and with which
options it is run, is the comparison's: tests/compare/README.md. Look at each picture before it is kept."""
import struct
import sys
import zlib
from argparse import Namespace
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / 'compare'))
sys.dont_write_bytecode = True
import compare
import images

# Each scene with what it is here for. The second word of a name is the file in scenes/.
SCENES = {
    'gallery-machine': 'cylinders, cones, boxes and spheres, transformed',
    'gallery-mirror_hall': 'mirrors that see mirrors',
    'gallery-pool': 'panes and spheres of glass, coloured shadows',
    'gallery-quadric_hall': 'quadrics of each kind',
    'gallery-rose_window': 'polygons with holes, coloured light',
    'test-checker': 'patterns on moved objects, and the shadow of patterned glass',
    'test-everything_course': 'all of the course dialect',
    'test-filter_shadow': 'coloured shadows, course dialect',
    'test-nested_media': 'glass in glass, entered and left in order',
    'test-overlapping_media': 'glass that overlaps, left in another order',
    'test-phong': 'highlights of several exponents',
    'test-phong_metallic': 'metallic highlights of the povray dialect',
    'test-version_36': 'what a surface lets through, before version 3.7',
}


def keep(drawn, path):
    """The picture as drawn, without its date and the program's name: the same picture is the same file. Its values are
    linear, also where POV-Ray, before version 3.7, says otherwise."""
    with open(path, 'wb') as file:
        file.write(drawn[:8])
        for kind, body in images.png_chunks(drawn):
            if kind in (b'IHDR', b'IDAT', b'IEND'):
                file.write(chunk(kind, body))
            if kind == b'IHDR':
                file.write(chunk(b'gAMA', struct.pack('>I', 100000)))


def chunk(kind, body):
    return struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))


def main():
    options = Namespace(povray='povray', size='64x48', width=64, height=48, work=str(HERE))
    for name in SCENES:
        folder, _, stem = name.partition('-')
        compare.render_povray(compare.ROOT / 'scenes' / folder / f'{stem}.pov', options)
        source, = HERE.glob(f'{name}-????????????.pov')
        keep(source.with_suffix('.png').read_bytes(), HERE / f'{name}.png')
        source.with_suffix('.png').unlink()
        source.unlink()


if __name__ == '__main__':
    main()
