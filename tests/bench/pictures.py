"""Holds the programs' pictures against each other, as linear light from 0 to 1."""
import os
import re
import sys
from pathlib import Path

try:
    import numpy
except ImportError:
    # A python of one's own in front of the path often lacks numpy where the system's python has it.
    if os.path.realpath(sys.executable) != os.path.realpath('/usr/bin/python3') and os.path.exists('/usr/bin/python3'):
        os.execv('/usr/bin/python3', ['/usr/bin/python3'] + sys.argv)
    sys.exit('bench: numpy is needed (Debian: python3-numpy)')

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / 'compare'))
import images

TOLERANCE = 2.0 / 255.0


def read_ppm(path):
    """A binary PPM of 16 bits, the larger byte first."""
    with open(path, 'rb') as file:
        data = file.read()
    header = re.match(rb'P6\s+(?:#.*\n)*(\d+)\s+(\d+)\s+65535\s', data)
    if not header:
        raise images.PictureError(f'{path}: not a PPM of 16 bits')
    width, height, start = int(header[1]), int(header[2]), header.end()
    if len(data) - start < width * height * 6:
        raise images.PictureError(f'{path}: ends early')
    return numpy.frombuffer(data, '>u2', width * height * 3, start).reshape(height, width, 3) / 65535.0


READERS = {'.ppm': read_ppm, '.png': images.read_png, '.pfm': lambda path: numpy.clip(images.read_pfm(path), 0, 1)}


def read(path):
    return READERS[Path(path).suffix](path)


def off_percent(one, other):
    """Pixels that differ by more than 2/255 in some channel; pictures of different sizes differ everywhere."""
    a, b = read(one), read(other)
    if a.shape != b.shape:
        return 100.0
    return float(100.0 * numpy.mean(numpy.abs(a - b).max(axis=2) > TOLERANCE))
