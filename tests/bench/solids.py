"""Solids made of others, tori, and a mesh: scenes of the bench, with lights or without."""
import math
import random

from formats import Look, Scene, vector

LOOKS = tuple(Look(rgb) for rgb in ((.85, .35, .25), (.3, .7, .35), (.3, .45, .85), (.85, .75, .3)))
LAMP = (((12, 18, -20), 1),)


def strewn(count, line, turned):
    """`count` times a shape with a place in a cube that fills the view."""
    draw = random.Random(count).random
    size = 2.4 / count ** (1.0 / 3.0)
    for number in range(count):
        turn = [360.0 * draw() for _ in range(3)]
        place = [2.0 * draw() - 1.0 for _ in range(3)]
        turning = 'rotate <%.5g,%.5g,%.5g> ' % tuple(turn) if turned else ''
        yield (f'{line} {LOOKS[number % 4].text()} {turning}scale {size * (0.25 + 0.25 * draw()):.5g} '
               f'translate {vector(place)} }}')


def cube_view(objects, lit):
    return Scene((0, 0, -4.4), (0, 0, 0), 42, lights=list(LAMP) if lit else [], background=(.4, .5, .7), objects=objects)


def csg(lit, turned=False):
    """Each a box that a sphere rounds, minus two cylinders and a sphere."""
    line = ('difference { intersection { box { -1, 1 } sphere { 0, 1.35 } } cylinder { -1.1*x, 1.1*x, .5 } '
            'cylinder { -1.1*y, 1.1*y, .5 } sphere { <.9,.9,-.9>, .6 }')
    return lambda count: cube_view(lambda: strewn(count, line, turned), lit)


def tori(lit):
    return lambda count: cube_view(lambda: strewn(count, 'torus { .75, .25', True), lit)


def bored(count):
    """A box minus many small spheres, which together are one and a half times as large as it."""
    def lay():
        draw = random.Random(count).random
        radius = (1.5 * 8.0 / count / (4.0 / 3.0 * math.pi)) ** (1.0 / 3.0)
        yield 'difference { box { -1, 1 }'
        for _ in range(count):
            yield f'  sphere {{ {vector([2.0 * draw() - 1.0 for _ in range(3)])}, {radius * (0.6 + 0.6 * draw()):.5g} }}'
        yield f'  {LOOKS[0].text()} rotate <20,30,0> }}'
    return cube_view(lay, False)


def mesh(count):
    """Hills of about `count` triangles."""
    side = round(math.sqrt(count / 2.0)) + 1

    def height(x, z):
        return (.3 * math.sin(2.3 * x + .7 * z) * math.cos(1.7 * z) + .08 * math.sin(9 * x) * math.cos(11 * z + x)
                + .01 * math.sin(71 * x + 13 * z) * math.cos(67 * z) + .002 * math.sin(331 * x) * math.cos(347 * z))

    def corner(number):
        x, z = 4.0 * (number % side) / (side - 1) - 2.0, 4.0 * (number // side) / (side - 1) - 2.0
        return '<%.6g,%.6g,%.6g>' % (x, height(x, z), z)

    def face(number):
        low = number % (side - 1) + number // (side - 1) * side
        return f'<{low},{low + 1},{low + side}>,<{low + 1},{low + side + 1},{low + side}>'

    def lay():
        yield f'mesh2 {{ vertex_vectors {{ {side * side}'
        for number in range(side * side):
            yield ',' + corner(number)
        yield f'}} face_indices {{ {2 * (side - 1) ** 2}'
        for number in range((side - 1) ** 2):
            yield ',' + face(number)
        yield f'}} {LOOKS[1].text()} }}'
    return Scene((0, 1.9, -3.2), (0, -.2, 0), 46, lights=[((6, 9, -4), 1)], background=(.4, .5, .7), objects=lay)
