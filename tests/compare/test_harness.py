#!/usr/bin/env python3
"""Tests of the comparison itself: that it reads pictures rightly, and that it finds a wrong one. Needs no POV-Ray."""
import os
import stat
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent

try:
    import numpy
except ImportError:
    SYSTEM = '/usr/bin/python3'
    if os.path.exists(SYSTEM) and os.path.realpath(sys.executable) != os.path.realpath(SYSTEM):
        os.execv(SYSTEM, [SYSTEM] + sys.argv)
    sys.exit('test_harness: numpy is needed (Debian: python3-numpy)')

sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))
import compare
import equivalent
import images


def filter_row(kind, row, above, step):
    """The forward PNG filter, byte by byte from the definition."""
    out = bytearray()
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        guess = [0, left, above[i], (left + above[i]) // 2, images.paeth(left, above[i], corner)][kind]
        out.append((value - guess) & 255)
    return bytes(out)


def write_png(path, samples, kinds=(0,)):
    """A 16-bit RGB PNG whose rows use the given filters in turn."""
    height, width = samples.shape[:2]
    above, raw = bytes(width * 6), b''
    for y in range(height):
        row, kind = samples[y].astype('>u2').tobytes(), kinds[y % len(kinds)]
        raw += bytes([kind]) + filter_row(kind, row, above, 6)
        above = row
    chunks = [(b'IHDR', struct.pack('>IIBBBBB', width, height, 16, 2, 0, 0, 0)), (b'gAMA', struct.pack('>I', 45455)),
              (b'IDAT', zlib.compress(raw)), (b'IEND', b'')]
    body = b''.join(struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
                    for kind, data in chunks)
    Path(path).write_bytes(b'\x89PNG\r\n\x1a\n' + body)


def write_pfm(path, values, order='<'):
    scale = -1.0 if order == '<' else 1.0
    Path(path).write_bytes(b'PF\n%d %d\n%.1f\n' % (values.shape[1], values.shape[0], scale)
                           + values[::-1].astype(order + 'f4').tobytes())


class Pictures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = self.folder.name + '/picture'
        self.samples = numpy.random.default_rng(1).integers(0, 65536, (11, 7, 3))

    def tearDown(self):
        self.folder.cleanup()

    def test_png_with_every_filter(self):
        write_png(self.path, self.samples, (0, 1, 2, 3, 4))
        self.assertTrue((images.read_png(self.path) * 65535 == self.samples).all())

    def test_pfm_of_both_byte_orders(self):
        for order in '<>':
            # The first byte of the samples may look like white space and must not be taken for the header's.
            values = numpy.full((4, 3, 3), struct.unpack(order + 'f', b'\x20\x0a\x20\x0a')[0])
            values[0, 0] = 1, 2, 3
            write_pfm(self.path, values, order)
            self.assertTrue((images.read_pfm(self.path) == values.astype('f4')).all())

    def test_what_is_no_picture(self):
        for data in (b'', b'PF\n3 3\n-1.0\n123', b'\x89PNG\r\n\x1a\n', b'P6\n1 1\n255\nabc'):
            Path(self.path).write_bytes(data)
            for reader in (images.read_png, images.read_pfm):
                self.assertRaises(images.PictureError, reader, self.path)

    def test_stored_values(self):
        picture = numpy.array([[[0.5, -1.0, 3.0], [numpy.nan, numpy.inf, 0.04]]])
        self.assertEqual(compare.stored(picture).tolist(), [[[0.5, 0, 1], [2, 2, 0.04]]])


class Texts(unittest.TestCase):
    def test_dialect(self):
        course = 'sphere { <0, 0, 0>, 1 // transmit\n /* matrix /* */ open */ pigment { color rgbf <1, .5, -.5, +1e-3> } }'
        self.assertEqual(equivalent.dialect(course), 'course')
        for word in ('#version 3.7;', 'open', 'matrix', 'x', '2*2', 'rgbt', 'transmit', 'background', '"a"', '#', 'pi'):
            self.assertEqual(equivalent.dialect(course + ' ' + word), 'povray', word)

    def test_camera_of_the_course(self):
        text = equivalent.povray_text('camera { location <1,2,3> look_at 0 up <0,0,2> angle 60 translate <1,0,0> }')
        self.assertIn('camera { location <1.0,2.0,3.0> right <1.33333,0,0> up <0,2.0,0> sky <0.0,0.0,2.0> '
                      'look_at <0.0,0.0,0.0> angle 60.0 translate <1.0,0.0,0.0> }', text)
        self.assertIn('ambient_light rgb <0,0,0>', text)

    def test_up_along_the_view(self):
        text = equivalent.povray_text('camera { location <0,5,0> look_at <0,0,0> up <0,1,0> }')
        self.assertIn('sky <1.0,0.0,0.0>', text)

    def test_sphere_without_centre(self):
        self.assertIn('sphere { <0,0,0> , 2 }', equivalent.povray_text('sphere { 2 }'))
        self.assertIn('sphere { < 1 , 0 , 0 > , 2 }', equivalent.povray_text('sphere { <1,0,0>, 2 }'))
        self.assertNotIn('<0,0,0> ,', equivalent.povray_text('sphere { 0, 2 }'))

    def test_povray_text_is_left_alone(self):
        text = '#version 3.7;\nsphere { 0, 1 /* r */ }'
        self.assertEqual(equivalent.povray_text(text), text)


class WholeRun(unittest.TestCase):
    """Both programs are played by scripts that copy a prepared picture."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = Path(self.folder.name)
        samples = numpy.random.default_rng(2).integers(0, 65536, (24, 32, 3))
        self.values = samples / 65535.0
        write_png(self.path / 'picture.png', samples)
        (self.path / 'a.pov').write_text('#version 3.7;\n')
        self.script('povray', 'for word; do case $word in +O*) cp picture.png "${word#+O}";; esac; done')
        self.script('povc', 'cp picture.pfm "$4"')

    def tearDown(self):
        self.folder.cleanup()

    def script(self, name, line):
        path = self.path / name
        path.write_text(f'#!/bin/sh\n{line}\n')
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def run_with(self, values):
        write_pfm(self.path / 'picture.pfm', values)
        command = [sys.executable, str(HERE / 'compare.py'), '--povc', './povc', '--povray', './povray',
                   '--size', '32x24', '--work', 'work', '--csv', 'table.csv', 'a.pov']
        result = subprocess.run(command, cwd=self.path, stdout=subprocess.PIPE, text=True)
        return result.returncode, result.stdout

    def test_equal_pictures_hold(self):
        code, text = self.run_with(self.values)
        self.assertEqual(code, 0, text)
        self.assertIn(': held', text)
        self.assertTrue((self.path / 'table.csv').read_text().count('\n') == 2)

    def test_three_wrong_pixels_do_not(self):
        wrong = self.values.copy()
        wrong[5, 5:8] = (wrong[5, 5:8] + 0.5) % 1.0
        code, text = self.run_with(wrong)
        self.assertEqual(code, 1)
        self.assertIn('0.3906', text)
        self.assertIn('NOT HELD', text)

    def test_not_a_number_is_wrong(self):
        wrong = self.values.copy()
        wrong[5, 5:8] = numpy.nan
        self.assertEqual(self.run_with(wrong)[0], 1)

    def test_an_upside_down_picture_is_wrong(self):
        self.assertEqual(self.run_with(self.values[::-1])[0], 1)

    def test_a_program_that_fails(self):
        self.script('povc', 'echo "a.pov:1:1: error: no"; exit 1')
        code, text = self.run_with(self.values)
        self.assertEqual(code, 1)
        self.assertIn('a.pov:1:1: error: no', text)


if __name__ == '__main__':
    result = unittest.main(exit=False).result
    wrong = len(result.failures) + len(result.errors)
    print(f'{result.testsRun - wrong} passed, {wrong} failed')
    sys.exit(1 if wrong else 0)
