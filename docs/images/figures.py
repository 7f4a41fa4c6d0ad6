#!/usr/bin/env python3
"""Draw the two figures of docs/internals.md as SVG into this folder, and as PNG where rsvg-convert is installed."""
import math
import shutil
import subprocess
from pathlib import Path
from xml.sax.saxutils import escape

INK, GREY, PAPER = '#222222', '#7a7a7a', '#ffffff'
BLUE, GREEN, ORANGE, YELLOW = '#d6e6f5', '#d8efe2', '#fbe3d0', '#fbf4cc'
RAY, DARK_GREEN, DARK_ORANGE = '#b03a00', '#1d7a4d', '#c96a12'


class Figure:
    def __init__(self, width, height):
        self.width, self.height, self.items = width, height, []

    def add(self, element):
        self.items.append(element)

    def box(self, x, y, width, height, fill=PAPER, stroke=INK, dash='', line=1.5, radius=6):
        self.add(f'<rect x="{x}" y="{y}" width="{width}" height="{height}" rx="{radius}" fill="{fill}" stroke="{stroke}" '
                 f'stroke-width="{line}"{f" stroke-dasharray={chr(34)}{dash}{chr(34)}" if dash else ""}/>')

    def circle(self, x, y, radius, fill, stroke=INK, line=1.5):
        self.add(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{stroke}" stroke-width="{line}"/>')

    def text(self, x, y, words, size=15, weight='normal', anchor='start', fill=INK, style='normal'):
        self.add(f'<text x="{x}" y="{y}" font-size="{size}" font-weight="{weight}" font-style="{style}" '
                 f'text-anchor="{anchor}" fill="{fill}">{escape(words)}</text>')

    def lines(self, x, y, words, size=13, step=17, **style):
        for number, line in enumerate(words):
            self.text(x, y + number * step, line, size, **style)

    def line(self, x1, y1, x2, y2, stroke=INK, line=1.5, dash=''):
        self.add(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{stroke}" stroke-width="{line}"'
                 f'{f" stroke-dasharray={chr(34)}{dash}{chr(34)}" if dash else ""}/>')

    def arrow(self, x1, y1, x2, y2, stroke=INK, line=2, dash=''):
        angle, size = math.atan2(y2 - y1, x2 - x1), 9
        tip = ' '.join(f'{x2 - size * math.cos(angle + turn):.1f},{y2 - size * math.sin(angle + turn):.1f}'
                       for turn in (-0.45, 0.45))
        self.line(x1, y1, x2 - 6 * math.cos(angle), y2 - 6 * math.sin(angle), stroke, line, dash)
        self.add(f'<polygon points="{x2:.1f},{y2:.1f} {tip}" fill="{stroke}"/>')

    def room(self, x, y, width, height, name, words, fill):
        self.box(x, y, width, height, fill)
        self.text(x + width / 2, y + 22, name, 15, 'bold', 'middle')
        for number, line in enumerate(words):
            self.text(x + width / 2, y + 42 + 16 * number, line, 12.5, anchor='middle')

    def save(self, name):
        path = Path(__file__).with_name(f'{name}.svg')
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                        f'viewBox="0 0 {self.width} {self.height}" font-family="DejaVu Sans, Verdana, sans-serif">\n'
                        f'<rect width="{self.width}" height="{self.height}" fill="{PAPER}"/>\n' + '\n'.join(self.items) + '\n</svg>\n')
        if shutil.which('rsvg-convert'):
            subprocess.run(['rsvg-convert', '--zoom', '1.5', str(path), '-o', str(path.with_suffix('.png'))], check=True)


def text_to_pixel():
    f = Figure(1080, 600)
    f.text(20, 30, 'Once for each scene', 16, 'bold')
    f.box(20, 62, 100, 84, PAPER, GREY)
    f.lines(70, 98, ['scene', 'text'], 14, 19, anchor='middle')
    f.arrow(120, 104, 158, 104)
    f.room(160, 50, 220, 108, 'sdl', ['source, lexer, token buffer', 'scopes, values, expressions', 'parse_<thing>: statements', 'add to the model'], BLUE)
    f.arrow(380, 104, 418, 104)
    f.room(420, 50, 180, 108, 'model', ['leaves and groups', 'textures, interiors', 'lights, camera, settings', 'plain data, text order'], BLUE)
    f.arrow(600, 104, 638, 104)
    f.room(640, 50, 200, 108, 'world, bvh', ['leaf batches, instances', 'tree of bounding boxes', 'which objects are plain', 'what the scene needs'], BLUE)
    f.arrow(840, 104, 878, 104)
    f.box(880, 62, 180, 84, PAPER, GREY)
    f.lines(970, 98, ['compiled scene', 'never changes again'], 14, 19, anchor='middle')

    f.box(160, 196, 680, 56, YELLOW, INK, '6 4')
    f.text(500, 219, 'primitive plugins: one file, one keyword', 14.5, 'bold', 'middle')
    f.text(500, 239, 'parse, bounds, absorb  |  block filter, intersect, normal, inside', 13, anchor='middle')
    f.arrow(270, 196, 270, 160, GREY, 1.5)
    f.arrow(740, 196, 740, 160, GREY, 1.5)

    f.text(20, 300, 'For each batch of up to 64 rays', 16, 'bold')
    f.room(20, 322, 190, 124, 'render', ['tiles, passes, samples', 'camera rays of a tile', 'error estimate', 'framebuffer'], GREEN)
    f.room(290, 322, 210, 124, 'query', ['nearest hits of a packet', 'occlusion and crossings', 'of shadow rays', 'coincident surfaces'], GREEN)
    f.room(560, 322, 200, 124, 'shade', ['points, normals, appearance', 'emitted and received light', 'transmittance of shadows', 'reflected, refracted rays'], GREEN)
    f.room(840, 322, 220, 54, 'texture', ['point to appearance'], ORANGE)
    f.room(840, 392, 220, 54, 'light', ['point to light sample'], ORANGE)
    f.arrow(210, 362, 288, 362)
    f.text(249, 354, 'rays', 12.5, anchor='middle')
    f.arrow(500, 362, 558, 362)
    f.text(529, 354, 'hits', 12.5, anchor='middle')
    f.arrow(760, 349, 838, 349)
    f.arrow(760, 419, 838, 419)
    f.line(970, 146, 970, 272, GREY, 1.5)
    f.line(970, 272, 395, 272, GREY, 1.5)
    f.arrow(395, 272, 395, 320, GREY, 1.5)
    f.line(340, 252, 340, 300, GREY, 1.5)
    f.arrow(340, 300, 340, 320, GREY, 1.5)
    # New rays go back to the query.
    f.line(620, 446, 620, 478, RAY, 2)
    f.line(620, 478, 440, 478, RAY, 2)
    f.arrow(440, 478, 440, 448, RAY)
    f.text(530, 496, 'reflected and refracted rays: next batches', 12.5, anchor='middle', fill=RAY)
    f.line(720, 446, 720, 512, RAY, 2)
    f.line(720, 512, 340, 512, RAY, 2)
    f.arrow(340, 512, 340, 448, RAY)
    f.text(530, 530, 'shadow rays, one per surface and light', 12.5, anchor='middle', fill=RAY)
    f.line(690, 446, 690, 560, INK, 2)
    f.line(690, 560, 115, 560, INK, 2)
    f.arrow(115, 560, 115, 448)
    f.text(388, 578, 'colour, added to the sample of the camera ray', 12.5, anchor='middle')
    f.arrow(60, 446, 60, 556)
    f.text(24, 576, 'picture', 14, 'bold')
    f.save('text-to-pixel')


def ray_way(f, x1, y1, x2, y2):
    f.arrow(x1, y1, x2, y2, RAY, 2.5)


def tree_panel(f):
    f.text(20, 30, '1  Tree', 17, 'bold')
    f.box(20, 46, 320, 220, PAPER, INK, radius=0)
    for x, y, width, height, fill in ((34, 60, 90, 70, PAPER), (34, 160, 120, 90, GREEN), (170, 60, 80, 60, PAPER),
                                      (180, 130, 140, 116, GREEN), (266, 56, 60, 60, PAPER)):
        f.box(x, y, width, height, fill, INK if fill == GREEN else GREY, '' if fill == GREEN else '4 3', radius=0)
    f.box(206, 146, 92, 84, YELLOW, INK, radius=0)
    f.text(252, 193, 'leaf', 13, anchor='middle')
    ray_way(f, 4, 256, 336, 146)
    f.lines(20, 292, ['A node has eight child boxes, as floats in a local', 'frame, rounded outward. One slab test decides all',
                      'eight: no box that the ray meets is ever missed.', 'Children are visited from near to far. A child that',
                      'begins behind the nearest hit so far is skipped.'])


def leaf_panel(f):
    f.text(380, 30, '2  Leaf: the block filter', 17, 'bold')
    f.box(380, 46, 320, 220, YELLOW, INK, radius=0)
    for x, y, radius, fill in ((430, 90, 30, PAPER), (590, 88, 26, PAPER), (446, 200, 36, GREEN), (546, 207, 34, ORANGE),
                               (632, 140, 34, GREEN), (668, 236, 18, PAPER)):
        f.circle(x, y, radius, fill, GREY if fill == PAPER else INK)
    for x, y, word in ((430, 94, 'no'), (590, 92, 'no'), (446, 188, 'definite'), (546, 212, 'possible'), (632, 164, 'definite'),
                       (668, 240, 'no')):
        f.text(x, y, word, 12, anchor='middle')
    ray_way(f, 366, 240, 712, 108)
    f.lines(380, 292, ['Up to eight shapes of one class, in SIMD lanes.', 'A float test with error bounds answers for each:',
                       'no: the ray misses it, certainly;', 'definite: the ray hits it, between lo and hi;',
                       'possible: the floats cannot tell.'])


def exact_panel(f):
    f.text(740, 30, '3  Exact test', 17, 'bold')
    f.box(740, 46, 320, 220, PAPER, INK, radius=0)
    f.circle(900, 212, 118, ORANGE)
    f.add('<rect x="741" y="267" width="318" height="70" fill="#ffffff"/>')
    f.line(740, 266, 1060, 266, INK)
    ray_way(f, 726, 80, 1072, 104)
    f.line(740, 74, 1060, 96.2, DARK_ORANGE, 1, '4 3')
    f.line(740, 88, 1060, 110.2, DARK_ORANGE, 1, '4 3')
    f.text(752, 66, 'error bound of double', 12, fill=DARK_ORANGE)
    f.circle(898, 92, 4, RAY, RAY)
    f.text(900, 170, 'hit or miss?', 14, anchor='middle')
    f.text(900, 192, 'the sign of an expression', 12.5, anchor='middle')
    f.lines(740, 292, ['Plain double with a running error bound decides', 'nearly always. Where the bound leaves the sign',
                       'open, double-double arithmetic or exact sums', 'decide it. No epsilon takes part. The distance',
                       'of the hit is a double-double, t + t_lo.'])


def order_panel(f):
    f.text(20, 410, 'Order of work for one ray of a packet', 17, 'bold')
    f.room(20, 450, 200, 84, 'traverse', ['the ray meets a box:', 'go on to its children'], GREEN)
    f.room(260, 450, 220, 84, 'filter', ['at a leaf: all rays of the', 'packet that reach it'], YELLOW)
    f.room(530, 424, 260, 62, 'possible', ['exact test at once; a hit lowers the limit'], ORANGE)
    f.room(530, 498, 260, 62, 'definite', ['deferred; its hi lowers the limit'], BLUE)
    f.room(830, 487, 230, 84, 'when the traversal ends', ['exact test of those deferred', 'hits that may be the nearest'], BLUE)
    f.arrow(220, 492, 258, 492)
    f.arrow(480, 480, 528, 458)
    f.arrow(480, 504, 528, 526)
    f.arrow(790, 529, 828, 529)
    f.lines(20, 598, ['A shadow ray ends at the first definite hit of an opaque shape. Coincident surfaces (distances equal as far as doubles tell) '
                      'are told', 'apart in double-double at the end. The surface that a ray starts on is excluded by name, before the traversal.'])


def ray():
    f = Figure(1080, 630)
    for panel in (tree_panel, leaf_panel, exact_panel, order_panel):
        panel(f)
    f.save('ray')


if __name__ == '__main__':
    text_to_pixel()
    ray()
