#!/usr/bin/env python3
"""Writes the scenes of this folder, which are kept beside it: run it after changing it.

The language of the scenes has neither loops nor names yet, so what is repeated is written out here.
"""
import math
import sys
from pathlib import Path


def vector(*components):
    """A vector as short as four decimals allow."""
    return '<' + ', '.join(number(component) for component in components) + '>'


def number(value):
    return f'{value:.4f}'.rstrip('0').rstrip('.') if abs(value) >= 5e-5 else '0'


def colour(*components):
    return f'pigment {{ rgb {vector(*components)} }}'


def sphere(centre, radius, *look):
    return f'sphere {{ {vector(*centre)}, {number(radius)} {" ".join(look)} }}'


def box(a, b, *look):
    return f'box {{ {vector(*a)}, {vector(*b)} {" ".join(look)} }}'


def cylinder(a, b, radius, *look):
    return f'cylinder {{ {vector(*a)}, {vector(*b)}, {number(radius)} {" ".join(look)} }}'


def cone(a, radius_a, b, radius_b, *look):
    return f'cone {{ {vector(*a)}, {number(radius_a)}, {vector(*b)}, {number(radius_b)} {" ".join(look)} }}'


def polygon(loops, *look):
    """A polygon of one loop or several, a line each; its first point closes a loop."""
    rows = [list(loop) + [loop[0]] for loop in loops]
    text = ',\n    '.join(', '.join(vector(*point) for point in row) for row in rows)
    return f'polygon {{ {sum(len(row) for row in rows)},\n    {text}\n    {" ".join(look)} }}'


def mixed(a, b, part):
    """Between a and b, component by component."""
    return tuple(x + (y - x) * part for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def along(origin, *steps):
    """origin + s1 v1 + s2 v2 + ... for steps (s, v)."""
    return tuple(o + sum(s * v[i] for s, v in steps) for i, o in enumerate(origin))


def sphereflake():
    """Eric Haines's sphereflake: nine balls of a third of the radius on every ball, three levels deep."""
    tints = ((0.80, 0.46, 0.14), (0.72, 0.20, 0.10), (0.50, 0.10, 0.16), (0.82, 0.70, 0.52))
    lines = ['''// A sphereflake: nine balls of a third of the radius sit on every ball, six around its waist, three above.
// The sky is a wide ball; a low sun just within it makes the glow at the horizon and the rims of light.
global_settings { assumed_gamma 1 max_trace_level 6 ambient_light rgb <0.55, 0.75, 1.2> }
camera { location <2.2, 1.35, -6.9> look_at <0.02, 1.08, 0> angle 37 }
light_source { <-2200, 4300, -4800> rgb <1.15, 1.02, 0.9> }
light_source { <-1290, 170, 2620> rgb <5, 2.1, 0.7> }

sphere { 0, 3000 no_shadow pigment { rgb <1, 0.94, 0.9> }
    finish { ambient rgb <0.02, 0.055, 0.13> diffuse 0.11 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0.02
    pigment { rgb <0.06, 0.07, 0.10> } finish { ambient 0.1 diffuse 0.7 reflection 0.42 } }
''']

    def ball(centre, radius, axis, level):
        lines.append(sphere(centre, radius, colour(*tints[level]),
                            'finish { ambient 0.05 diffuse 0.6 reflection 0.3 phong 0.8 phong_size 120 }'))
        if level == 3:
            return
        side = unit(cross(axis, (0.31, 0.17, 0.93)))
        front = cross(axis, side)
        for count, height, turn in ((6, 0.0, 0.0), (3, math.sqrt(2.0 / 3.0), math.pi / 6)):
            for i in range(count):
                angle = turn + 2 * math.pi * i / count
                flat = math.sqrt(1 - height * height)
                out = along((0, 0, 0), (flat * math.cos(angle), side), (flat * math.sin(angle), front),
                            (height, axis))
                ball(along(centre, (radius * 4 / 3, out)), radius / 3, out, level + 1)

    ball((0, 0.92, 0), 0.9, unit((0.05, 1, -0.12)), 0)
    return lines


def pool():
    """Glass and water: a tiled pool with glass balls in it, coloured panes and balls on its rim."""
    lines = ['''// Glass and water. The light comes from behind, so that coloured panes and balls throw their colours
// towards the camera; balls of glass lie on the tiles under water, and a pillar breaks at the surface.
global_settings { assumed_gamma 1 max_trace_level 12 ambient_light rgb <0.7, 0.85, 1> }
camera { location <0.9, 5.2, -11.2> look_at <-0.1, 0.05, 0.9> angle 47 }
light_source { <-2600, 5200, 4700> rgb <1.2, 1.08, 0.9> }
light_source { <0, 2900, 0> rgb <0.16, 0.22, 0.3> }
sphere { 0, 3000 no_shadow pigment { rgb <0.75, 0.88, 1> }
    finish { ambient rgb <0.1, 0.16, 0.26> diffuse 0.55 } }

// The pool: rim, walls, grout under the tiles, and the water, whose sides end inside the walls.
box { <-14, -3, -12>, <14, 0.25, 0> pigment { rgb <0.78, 0.72, 0.62> } }
box { <-14, -3, 8.5>, <14, 0.25, 30> pigment { rgb <0.78, 0.72, 0.62> } }
box { <-14, -3, -1>, <-7, 0.24, 9> pigment { rgb <0.70, 0.64, 0.55> } }
box { <7, -3, -1>, <14, 0.24, 9> pigment { rgb <0.70, 0.64, 0.55> } }
box { <-14, -3, -1>, <14, -1.84, 9> pigment { rgb <0.5, 0.5, 0.45> } }
box { <-7.5, -2.5, -0.5>, <7.5, -0.12, 9> pigment { rgbf <0.72, 0.93, 0.96, 0.94> }
    finish { ambient 0 diffuse 0.1 reflection 0.13 phong 0.6 phong_size 250 } interior { ior 1.33 } }

// On the rim: panes and balls.
box { <-0.95, 0.2, -0.03>, <0.95, 2.1, 0.03> rotate <0, 24, 0> translate <-3, 0, -1.3>
    pigment { rgbf <1, 0.16, 0.08, 0.92> } finish { ambient 0 diffuse 0.2 reflection 0.08 } }
box { <-0.95, 0.2, -0.03>, <0.95, 1.75, 0.03> rotate <0, -12, 0> translate <-1.5, 0, -1.9>
    pigment { rgbf <1, 0.72, 0.06, 0.92> } finish { ambient 0 diffuse 0.2 reflection 0.08 } }
box { <-0.8, 0.2, -0.03>, <0.8, 2.4, 0.03> rotate <0, 30, 0> translate <0.1, 0, -1.1>
    pigment { rgbf <0.08, 0.34, 1, 0.92> } finish { ambient 0 diffuse 0.2 reflection 0.08 } }
sphere { <1.75, 1.1, -2.5>, 0.8 pigment { rgbf <0.97, 1, 0.98, 0.96> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.1 phong 0.9 phong_size 200 } }
sphere { <3.25, 0.8, -1.9>, 0.5 pigment { rgbf <0.15, 0.95, 0.45, 0.94> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.1 phong 0.9 phong_size 200 } }
sphere { <2.9, 0.7, -3.5>, 0.4 pigment { rgbf <0.95, 0.25, 0.65, 0.94> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.1 phong 0.9 phong_size 200 } }
sphere { <-3.6, 0.65, -3.4>, 0.35 pigment { rgbf <0.35, 0.75, 1, 0.94> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.1 phong 0.9 phong_size 200 } }

// In the water: pillars, and balls on the floor.
cylinder { <3.4, -1.9, 4.4>, <3.4, 1.7, 4.4>, 0.5 pigment { rgb <0.9, 0.87, 0.8> } }
sphere { <3.4, 2.15, 4.4>, 0.62 pigment { rgb <0.8, 0.5, 0.2> }
    finish { reflection 0.35 phong 0.8 phong_size 80 } }
cylinder { <-4.4, -1.9, 5.2>, <-4.4, 1.1, 5.2>, 0.5 pigment { rgb <0.9, 0.87, 0.8> } }
sphere { <-4.4, 1.55, 5.2>, 0.62 pigment { rgb <0.8, 0.5, 0.2> }
    finish { reflection 0.35 phong 0.8 phong_size 80 } }
cylinder { <-1.9, -1.7, 5.5>, <-0.1, 1.4, 2.6>, 0.07 pigment { rgb <0.75, 0.12, 0.08> } finish { phong 0.6 } }
sphere { <0.9, -1.1, 3.2>, 0.7 pigment { rgbf <1, 0.8, 0.35, 0.93> } interior { ior 1.65 }
    finish { ambient 0 diffuse 0.1 reflection 0.1 phong 0.8 phong_size 120 } }
sphere { <-1.9, -1.35, 2.4>, 0.45 pigment { rgbf <0.95, 0.35, 0.5, 0.93> } interior { ior 1.65 }
    finish { ambient 0 diffuse 0.1 reflection 0.1 phong 0.8 phong_size 120 } }
sphere { <-3.2, -1.2, 3.1>, 0.6 pigment { rgb <0.92, 0.9, 0.85> } finish { phong 0.4 } }
// The paving around it, and a garden behind.
box { <-40, -0.2, 16>, <40, 1.1, 16.6> pigment { rgb <0.55, 0.24, 0.13> } }
box { <-40, 1.1, 15.9>, <40, 1.25, 16.7> pigment { rgb <0.75, 0.66, 0.55> } }''']
    stones = ((0.74, 0.67, 0.56), (0.67, 0.60, 0.50), (0.79, 0.73, 0.63), (0.70, 0.61, 0.49))
    for row in range(14):
        for column in range(16):
            x, z = 2 * column - 16 + (row % 2), 2 * row - 11.97
            if z + 1.94 > 0.01 and z < 8.5 and x + 1.94 > -7 and x < 7:
                continue
            lines.append(box((x + 0.03, 0.2, z + 0.03), (x + 1.97, 0.29, z + 1.94),
                             colour(*stones[(row * 5 + column * 3 + row * column) % 4])))
    for i in range(11):
        x, z, tall = -15 + 3.1 * i, 18.5 + (i * 7 % 4), 4.6 + (i * 5 % 3) * 0.7
        lines.append(cone((x, 0, z), 1, (x, tall, z), 0, colour(0.04, 0.13, 0.06)))
    lines.append('// The tiles.')
    tints = ((0.16, 0.52, 0.56), (0.62, 0.80, 0.76), (0.10, 0.36, 0.48))
    for row in range(9):
        for column in range(15):
            tint = tints[(row * row + column * 2 + row * column) % 3]
            x, z = column - 7.5, row - 0.2
            lines.append(box((x + 0.03, -2, z + 0.03), (x + 0.97, -1.8, z + 0.97), colour(*tint)))
    return lines


def mirror_hall():
    """Two long mirrors face each other across a hall with a chequered floor."""
    lines = ['''// A hall of mirrors: the walls to the left and right are mirrors in gilt frames, so that it goes on and on.
global_settings { assumed_gamma 1 max_trace_level 30 adc_bailout 0.001 ambient_light rgb <1, 0.9, 0.75> }
camera { location <-2.25, 1.9, -3.6> look_at <1.2, 1.3, -0.55> angle 66 }
light_source { <0, 3.3, -1> rgb <0.62, 0.52, 0.4> }
light_source { <0, 3.3, 4> rgb <0.62, 0.5, 0.36> }
light_source { <-0.5, 2.4, -5.5> rgb <0.22, 0.26, 0.34> }

// Ceiling, end walls, mirrors.
box { <-3, 4, -7>, <3, 4.2, 9> pigment { rgb <0.42, 0.40, 0.46> } finish { ambient 0.16 } }
box { <-3, -0.2, 8.8>, <3, 4.1, 9> pigment { rgb <0.45, 0.12, 0.10> } finish { ambient 0.16 } }
box { <-3, -0.2, -7>, <3, 4.1, -6.8> pigment { rgb <0.45, 0.12, 0.10> } finish { ambient 0.16 } }
box { <-2.6, -0.2, -7>, <-2.5, 4.1, 9> pigment { rgb <0.02, 0.03, 0.03> }
    finish { ambient 0 diffuse 0.3 reflection 0.88 } }
box { <2.5, -0.2, -7>, <2.6, 4.1, 9> pigment { rgb <0.02, 0.03, 0.03> }
    finish { ambient 0 diffuse 0.3 reflection 0.88 } }

// The figure in the middle: a pedestal, a ball of glass, gilt cones.
cylinder { <0.35, 0, 0.6>, <0.35, 0.16, 0.6>, 0.62 pigment { rgb <0.14, 0.16, 0.2> }
    finish { reflection 0.15 phong 0.4 } }
cone { <0.35, 0.16, 0.6>, 0.44, <0.35, 0.95, 0.6>, 0.24 pigment { rgb <0.75, 0.72, 0.68> }
    finish { phong 0.3 } }
cylinder { <0.35, 0.95, 0.6>, <0.35, 1.03, 0.6>, 0.4 pigment { rgb <0.85, 0.6, 0.25> }
    finish { reflection 0.25 phong 0.8 metallic } }
sphere { <0.35, 1.45, 0.6>, 0.42 pigment { rgbf <0.82, 0.95, 1, 0.92> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.12 phong 1 phong_size 150 } }
cone { <0.35, 1.85, 0.6>, 0.16, <0.35, 2.5, 0.6>, 0 pigment { rgb <0.85, 0.6, 0.25> }
    finish { reflection 0.25 phong 0.8 metallic } }
sphere { <1.5, 0.33, -0.9>, 0.33 pigment { rgb <0.62, 0.06, 0.05> }
    finish { reflection 0.14 phong 0.8 phong_size 70 } }
sphere { <1.15, 0.22, -1.5>, 0.22 pigment { rgb <0.05, 0.2, 0.5> }
    finish { reflection 0.14 phong 0.8 phong_size 70 } }
// Floor, lamps, pillars and frames.''']
    for row in range(16):
        for column in range(5):
            x, z = column - 2.5, row - 7.0
            dark = (row + column) % 2
            tint = (0.05, 0.06, 0.09) if dark else (0.72, 0.68, 0.60)
            lines.append(box((x, -0.2, z), (x + 1, 0, z + 1), colour(*tint), 'finish { reflection 0.12 }'))
    for z in (-3.5, -1, 1.5, 4, 6.5):
        lines.append(cylinder((0, 3.55, z), (0, 4, z), 0.02, colour(0.85, 0.6, 0.25), 'no_shadow'))
        lines.append(sphere((0, 3.3, z), 0.26, colour(1, 0.86, 0.62), 'finish { ambient 1 diffuse 0 } no_shadow'))
    gilt = f'{colour(0.85, 0.6, 0.25)} finish {{ reflection 0.2 phong 0.7 metallic }}'
    for side in (-2.42, 2.42):
        for z in (-5.75, -2.25, 1.25, 4.75):
            lines.append(cylinder((side, 0.2, z), (side, 3.7, z), 0.09, colour(0.82, 0.78, 0.7)))
            lines.append(cone((side, 3.6, z), 0.09, (side, 4, z), 0.26, gilt))
            lines.append(cone((side, 0, z), 0.22, (side, 0.3, z), 0.09, gilt))
        lines.append(box((side - 0.06, 0, -7), (side + 0.06, 0.14, 9), gilt))
        lines.append(box((side - 0.06, 3.86, -7), (side + 0.06, 4, 9), gilt))
    return lines


def quadric_hall():
    """Hyperboloids of one sheet between two planes: a hall of flaring columns over still water."""
    lines = ['''// A hall of hyperboloids: each column flares into the vault and into the floor, which mirrors it. The far
// light is warm, the near one cool; an ellipsoid of brass floats between them.
global_settings { assumed_gamma 1 max_trace_level 8 ambient_light rgb <0.5, 0.6, 0.9> }
camera { location <0.75, 1.45, -15.2> look_at <-0.2, 2.05, 0> angle 50 }
light_source { <2, 1.7, 21> rgb <1.5, 0.85, 0.42> }
light_source { <0.6, 3.2, 6> rgb <0.55, 0.36, 0.2> }
light_source { <-0.6, 3.2, -6> rgb <0.34, 0.24, 0.15> }
light_source { <3.4, 2.2, -17> rgb <0.10, 0.24, 0.46> }

quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0 pigment { rgb <0.10, 0.13, 0.17> } finish { reflection 0.42 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, -1, 0>, 4.2 pigment { rgb <0.72, 0.66, 0.58> } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 0, -1>, 30 pigment { rgb <0.9, 0.6, 0.35> } finish { ambient 0.5 } }
quadric { <3.2, 1.6, 3.2>, <0.4, 0, 0.3>, <0, 0, 0>, -1 translate <0, 1.9, -2>
    pigment { rgb <0.75, 0.5, 0.18> } finish { reflection 0.45 phong 0.8 phong_size 60 metallic } }
quadric { <16, 16, 16>, <0, 0, 0>, <0, 0, 0>, -1 translate <-0.6, 3.2, -6> no_shadow
    pigment { rgb <1, 0.85, 0.6> } finish { ambient 3 diffuse 0 } }
// The columns.''']
    for row in range(-2, 7):
        for column in range(-3, 3):
            tint = (0.74, 0.68, 0.60) if (row + column) % 2 else (0.62, 0.64, 0.68)
            lines.append(f'quadric {{ <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 '
                         f'translate {vector(column * 4 + 2, 2.1, row * 4)} {colour(*tint)} }}')
    return lines


def fullerene():
    """Buckminsterfullerene, sixty atoms and ninety bonds, around a ball of glass."""
    golden = (1 + math.sqrt(5)) / 2
    atoms = set()
    for base in ((0, 1, 3 * golden), (1, 2 + golden, 2 * golden), (golden, 2, 2 * golden + 1)):
        for signs in range(8):
            point = tuple(x * (-1 if signs >> i & 1 else 1) + 0.0 for i, x in enumerate(base))
            for turn in range(3):
                atoms.add(tuple(round(point[(i + turn) % 3], 9) + 0.0 for i in range(3)))
    atoms = sorted(atoms)
    bonds = [(a, b) for i, a in enumerate(atoms) for b in atoms[i + 1:] if abs(math.dist(a, b) - 2) < 1e-6]
    assert len(atoms) == 60 and len(bonds) == 90
    lines = ['''// Buckminsterfullerene: sixty atoms and ninety bonds around a ball of blue glass, through which its far
// side is seen bent.
global_settings { assumed_gamma 1 max_trace_level 10 ambient_light rgb <0.6, 0.8, 1> }
camera { location <2, 3.2, -23.5> look_at <-0.1, -0.45, 0> angle 41 }
light_source { <-4200, 4600, -3900> rgb <1.45, 1.3, 1.12> }
light_source { <1500, 500, 2430> rgb <1.6, 3.0, 3.4> }
sphere { 0, 3000 no_shadow pigment { rgb 1 } finish { ambient rgb <0.008, 0.018, 0.028> diffuse 0.07 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 5.6 pigment { rgb <0.05, 0.065, 0.075> }
    finish { reflection 0.3 } }
sphere { <0, 0, 0>, 2.9 pigment { rgbf <0.35, 0.72, 1, 0.93> } interior { ior 1.45 }
    finish { ambient 0 diffuse 0.1 reflection 0.14 phong 0.9 phong_size 160 } }
// Beside it: water and methane.''']
    white = 'finish { phong 0.7 phong_size 50 reflection 0.05 }'
    hydrogen = colour(0.85, 0.85, 0.82)
    water = ((0.80, -0.25, 0.55), (-0.62, -0.2, 0.78))
    methane = ((0.9, -0.35, -0.3), (-0.5, -0.35, -0.8), (-0.4, -0.35, 0.85), (0, 1, 0))
    for centre, radius, tint, size, directions in (((5.9, -4.35, -4.6), 1.0, (0.75, 0.05, 0.04), 0.62, water),
                                                   ((-6.5, -4.25, -3.2), 1.1, (0.13, 0.13, 0.15), 0.66, methane)):
        lines.append(sphere(centre, radius, colour(*tint), white))
        for direction in directions:
            lines.append(sphere(along(centre, (radius * 1.15, unit(direction))), size, hydrogen, white))
    turn = 'rotate <12, 23, 8>'
    for a, b in bonds:
        lines.append(cylinder(a, b, 0.17, turn, colour(0.55, 0.60, 0.64), 'finish { phong 0.5 reflection 0.12 }'))
    for atom in atoms:
        lines.append(sphere(atom, 0.5, turn, colour(0.80, 0.40, 0.12),
                            'finish { phong 0.8 phong_size 60 reflection 0.12 }'))
    return lines


def machine():
    """A model beam engine of cylinders and cones, with two gears in mesh."""
    brass, copper, steel = (0.80, 0.52, 0.16), (0.78, 0.30, 0.13), (0.50, 0.52, 0.55)
    green, black, wood = (0.04, 0.16, 0.10), (0.05, 0.05, 0.06), (0.30, 0.15, 0.07)
    shiny = 'finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic }'
    paint = 'finish { reflection 0.06 phong 0.6 phong_size 80 }'
    lines = ['''// A machine of cylinders and cones: boiler, chimney, a piston in glass, crank, flywheel and gears.
global_settings { assumed_gamma 1 max_trace_level 7 ambient_light rgb <0.8, 0.85, 1> }
camera { location <-2.2, 3.6, -9.8> look_at <0.12, 1.5, 0> angle 42 }
light_source { <-7, 9, -8> rgb <1.4, 1.28, 1.08> }
light_source { <9, 5, -6> rgb <0.26, 0.32, 0.44> }
light_source { <-2, 7, 5> rgb <0.36, 0.28, 0.2> }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0 pigment { rgb <0.14, 0.12, 0.11> } finish { reflection 0.16 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 0, -1>, 7 pigment { rgb <0.09, 0.13, 0.16> } }''']

    def rod(a, b, radius, tint, finish):
        lines.append(cylinder(a, b, radius, colour(*tint), finish))

    def taper(a, radius_a, b, radius_b, tint, finish):
        lines.append(cone(a, radius_a, b, radius_b, colour(*tint), finish))

    def ball(centre, radius, tint, finish):
        lines.append(sphere(centre, radius, colour(*tint), finish))

    def block(a, b, tint, finish):
        lines.append(box(a, b, colour(*tint), finish))

    def around(centre, radius, angle, z):
        return (centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle), z)

    def wheel(centre, radius, z, depth, spokes, tint, turn):
        """A rim of short staves, round spokes and a hub, in the plane of x and y."""
        staves = 40
        for i in range(staves):
            a, b = (turn + 2 * math.pi * (i + j) / staves for j in (0, 1))
            rod(around(centre, radius, a, z), around(centre, radius, b, z), depth, tint, shiny)
            ball(around(centre, radius, a, z), depth, tint, shiny)
        for i in range(spokes):
            a = turn + 2 * math.pi * i / spokes
            taper(centre[:2] + (z,), depth * 0.85, around(centre, radius, a, z), depth * 0.5, tint, shiny)
        rod(centre[:2] + (z - 2.2 * depth,), centre[:2] + (z + 2.2 * depth,), radius * 0.14, brass, shiny)

    def gear(centre, radius, teeth, z, tint, turn):
        """A disc with teeth of cut cones and six bolts."""
        rod(centre[:2] + (z - 0.11,), centre[:2] + (z + 0.11,), radius - 0.09, tint, shiny)
        rod(centre[:2] + (z - 0.17,), centre[:2] + (z + 0.17,), radius * 0.3, brass, shiny)
        for i in range(teeth):
            a = turn + 2 * math.pi * i / teeth
            taper(around(centre, radius - 0.12, a, z), 0.092, around(centre, radius + 0.07, a, z), 0.05,
                  tint, shiny)
        for i in range(6):
            a = turn + 2 * math.pi * (i + 0.5) / 6
            hole = around(centre, radius * 0.62, a, z)
            rod(hole[:2] + (z - 0.14,), hole[:2] + (z + 0.14,), radius * 0.11, steel, shiny)

    block((-3.9, 0.02, -1.5), (4.1, 0.3, 1.5), wood, paint)
    block((-3.8, 0.3, -1.4), (4.0, 0.36, 1.4), green, paint)

    # The boiler lies to the right at the back, with domes, bands, chimney and gauge.
    rod((0.2, 1.25, 0.75), (3.5, 1.25, 0.75), 0.62, green, paint)
    for x in (0.3, 1.3, 2.4, 3.4):
        rod((x - 0.05, 1.25, 0.75), (x + 0.05, 1.25, 0.75), 0.65, brass, shiny)
    ball((0.2, 1.25, 0.75), 0.6, copper, shiny)
    ball((3.5, 1.25, 0.75), 0.6, copper, shiny)
    for x in (0.8, 2.9):
        taper((x, 0.36, 0.75), 0.4, (x, 0.9, 0.75), 0.2, black, paint)
    taper((3.0, 1.75, 0.75), 0.34, (3.0, 2.15, 0.75), 0.22, black, paint)
    rod((3.0, 2.1, 0.75), (3.0, 3.7, 0.75), 0.2, black, paint)
    taper((3.0, 3.65, 0.75), 0.2, (3.0, 4.0, 0.75), 0.38, brass, shiny)
    rod((1.8, 1.8, 0.75), (1.8, 2.15, 0.75), 0.26, brass, shiny)
    ball((1.8, 2.15, 0.75), 0.26, brass, shiny)
    rod((1.0, 1.8, 0.6), (1.0, 2.2, 0.6), 0.05, copper, shiny)
    rod((1.0, 2.4, 0.55), (1.0, 2.4, 0.65), 0.24, brass, shiny)
    rod((1.0, 2.4, 0.54), (1.0, 2.4, 0.55), 0.2, (0.9, 0.88, 0.8), paint)
    taper((1.0, 2.4, 0.525), 0.025, (1.11, 2.52, 0.525), 0.005, (0.7, 0.05, 0.03), paint)

    # The working cylinder of glass stands in front of it with piston and rod.
    rod((2.2, 0.36, -0.75), (2.2, 0.5, -0.75), 0.52, brass, shiny)
    lines.append(cylinder((2.2, 0.5, -0.75), (2.2, 1.9, -0.75), 0.42, 'open pigment { rgbf <0.88, 0.97, 1, 0.9> }',
                          'finish { ambient 0 diffuse 0.1 reflection 0.12 phong 0.9 phong_size 120 }'))
    rod((2.2, 1.88, -0.75), (2.2, 2.0, -0.75), 0.52, brass, shiny)
    for i in range(6):
        a = 2 * math.pi * (i + 0.25) / 6
        x, z = 2.2 + 0.47 * math.cos(a), -0.75 + 0.47 * math.sin(a)
        rod((x, 0.4, z), (x, 2.06, z), 0.03, steel, shiny)
        ball((x, 2.08, z), 0.055, brass, shiny)
    rod((2.2, 1.05, -0.75), (2.2, 1.35, -0.75), 0.4, copper, shiny)
    for y in (1.12, 1.2, 1.28):
        rod((2.2, y - 0.015, -0.75), (2.2, y + 0.015, -0.75), 0.412, steel, shiny)
    rod((2.2, 1.35, -0.75), (2.2, 2.55, -0.75), 0.07, steel, shiny)
    pipe = ((1.8, 1.9, 0.75), (1.8, 2.3, 0.0), (2.2, 2.3, -0.2), (2.2, 1.95, -0.45))
    for a, b in zip(pipe, pipe[1:]):
        rod(a, b, 0.06, copper, shiny)
        ball(b, 0.075, copper, shiny)

    # The beam tilts on its post; rods go to the piston and to the crank.
    taper((0.55, 0.36, -0.75), 0.34, (0.55, 2.75, -0.75), 0.13, green, paint)
    ball((0.55, 2.86, -0.75), 0.2, brass, shiny)
    rod((0.55, 2.86, -1.05), (0.55, 2.86, -0.45), 0.1, steel, shiny)
    left, right = (-1.1, 3.17, -0.75), (2.2, 2.55, -0.75)
    for end in (left, right):
        taper((0.55, 2.86, -0.75), 0.17, end, 0.09, copper, shiny)
        ball(end, 0.13, brass, shiny)
        rod(end[:2] + (-0.95,), end[:2] + (-0.55,), 0.06, steel, shiny)
    axle = (-1.9, 1.55)
    pin = around(axle, 0.52, math.radians(35), -0.75)
    rod(left, pin, 0.06, steel, shiny)
    rod(pin[:2] + (-0.9,), pin[:2] + (-0.45,), 0.09, brass, shiny)
    taper(axle + (-0.5,), 0.16, pin[:2] + (-0.5,), 0.11, steel, shiny)

    # The flywheel behind the gears, on bearings of cones.
    wheel(axle, 1.12, 0.55, 0.09, 6, (0.50, 0.06, 0.05), 0.2)
    rod(axle + (-0.55,), axle + (1.1,), 0.09, steel, shiny)
    taper((-1.9, 0.36, -0.32), 0.26, (-1.9, 1.5, -0.32), 0.13, green, paint)
    taper((-1.9, 0.36, 1.0), 0.26, (-1.9, 1.5, 1.0), 0.13, green, paint)
    for z in (-0.32, 1.0):
        rod(axle + (z - 0.13,), axle + (z + 0.13,), 0.17, brass, shiny)
    gear(axle, 0.8, 24, 0.05, brass, 0.0)
    small = (axle[0] + 0.4 * 2 ** 0.5 * 1.5, axle[1] - 0.4 * 2 ** 0.5 * 1.5)
    gear(small, 0.4, 12, 0.05, copper, math.radians(-45 + 180) + math.pi / 12 * ((24 * 45 / 360 + 1) % 2))
    rod(small + (-0.4,), small + (0.5,), 0.06, steel, shiny)
    taper((small[0], 0.36, 0.4), 0.2, small + (0.4,), 0.08, green, paint)
    return lines


def rose_window():
    """A rose window of coloured polygons in a wall with a round hole, and its light on the floor."""
    lines = ['''// A rose window: polygons of coloured glass in a wall with a round hole in it, with the sun behind.
// Nothing colours the floor but the light that has come through them.
global_settings { assumed_gamma 1 max_trace_level 10 ambient_light rgb <0.42, 0.5, 0.72> }
camera { location <4.2, 4.6, -17> look_at <-0.9, 3.25, -1.8> angle 50 }
light_source { <1500, 4500, 4300> rgb <2.5, 2.3, 1.9> }
light_source { <-3, 6, -12> rgb <0.17, 0.18, 0.22> }
background { rgb <0.85, 0.95, 1.1> }
box { <-30, -0.3, -30>, <30, 0, 12> pigment { rgb <0.70, 0.66, 0.60> } finish { reflection 0.07 } }
box { <-9, 0, -30>, <-8.6, 30, 0> pigment { rgb <0.6, 0.56, 0.5> } }
box { <-9, 11, -30>, <20, 11.4, 0> pigment { rgb <0.3, 0.26, 0.22> } }
box { <12, 0, -30>, <12.4, 30, 0> pigment { rgb <0.6, 0.56, 0.5> } }''']
    centre, outer = (0.0, 5.2), 3.3

    def point(radius, angle):
        return (centre[0] + radius * math.sin(angle), centre[1] + radius * math.cos(angle))

    def pane(points, tint):
        lines.append(polygon([points], f'pigment {{ rgbf {vector(*tint, 0.95)} }}',
                             'finish { ambient 0 diffuse 0.15 reflection 0.04 }'))

    def lead(a, b, radius=0.035):
        lines.append(cylinder((*a, 0), (*b, 0), radius, colour(0.03, 0.03, 0.035)))

    def ring(radius, thick, parts):
        for i in range(parts):
            a, b = (point(radius, 2 * math.pi * (i + j) / parts) for j in (0, 1))
            lead(a, b, thick)
            lines.append(sphere((*a, 0), thick, colour(0.03, 0.03, 0.035)))

    circle = [point(outer, 2 * math.pi * i / 48) for i in range(48)]
    wall = [(-9, 0), (12, 0), (12, 11.2), (-9, 11.2)]
    stone = 'pigment { rgb <0.55, 0.51, 0.45> }'
    lines.append(polygon([wall, circle], stone, 'translate <0, 0, -0.15>'))
    lines.append(polygon([wall, circle], stone, 'translate <0, 0, 0.25>'))
    for i in range(48):
        a, b = circle[i], circle[(i + 1) % 48]
        lines.append(polygon([[(*a, -0.15), (*b, -0.15), (*b, 0.25), (*a, 0.25)]], colour(0.62, 0.58, 0.52)))
    ruby, gold, cobalt = (1, 0.06, 0.05), (1, 0.66, 0.08), (0.05, 0.16, 1)
    emerald, violet, sky = (0.06, 0.75, 0.22), (0.55, 0.12, 0.85), (0.35, 0.72, 1)
    for i in range(12):
        a, step = 2 * math.pi * i / 12, 2 * math.pi / 12
        mid, end = a + step / 2, a + step
        # From the middle out: a star, petals and the gaps between them, a band, and the border.
        pane([centre, point(0.75, a), point(0.52, mid), point(0.75, end)], gold if i % 2 else ruby)
        petal = [point(0.52, mid), point(0.75, end), point(1.65, end - 0.05), point(2.05, mid),
                 point(1.65, a + 0.05), point(0.75, a)]
        pane(petal, (cobalt, ruby)[i % 2])
        pane([point(2.05, mid), point(1.65, end - 0.05), point(0.75, end), point(1.65, end + 0.05),
              point(2.05, mid + step)], emerald if i % 2 else gold)
        arc = [point(2.42, mid + step * j / 6) for j in range(7)]
        pane([point(2.05, mid), point(2.05, mid + step)] + arc[::-1], sky if i % 2 else violet)
        for j in range(2):
            from_, to = mid + step * j / 2, mid + step * (j + 1) / 2
            pane([point(2.42, from_), point(2.42, to), point(outer, to), point(outer, from_)],
                 (cobalt, gold, ruby, sky, emerald, violet)[(2 * i + j) % 6])
            lead(point(2.42, from_), point(outer, from_))
        for p, q in zip(petal, petal[1:] + petal[:1]):
            lead(p, q)
        lead(point(2.05, mid), point(2.05, mid + step))
        lead(point(2.05, mid), point(2.42, mid))
        lead(centre, point(0.75, a))
    ring(2.42, 0.05, 48)
    ring(outer - 0.02, 0.09, 48)
    for x in (-5.2, 5.2):
        for z in (-1.2, -9.2):
            lines.append(cylinder((x, 0.5, z), (x, 9.4, z), 0.55, colour(0.62, 0.58, 0.52)))
            lines.append(cone((x, 9.3, z), 0.55, (x, 11, z), 1.3, colour(0.62, 0.58, 0.52)))
            lines.append(box((x - 0.85, 0, z - 0.85), (x + 0.85, 0.5, z + 0.85), colour(0.62, 0.58, 0.52)))
    lines.append(sphere((2.6, 0.8, -5), 0.8, colour(0.4, 0.4, 0.4), 'finish { reflection 0.65 phong 0.5 }'))
    return lines


SCENES = (sphereflake, pool, mirror_hall, quadric_hall, fullerene, machine, rose_window)


def main():
    wanted = sys.argv[1:]
    for scene in SCENES:
        if not wanted or scene.__name__ in wanted:
            path = Path(__file__).with_name(scene.__name__ + '.pov')
            path.write_text('\n'.join(scene()) + '\n')


if __name__ == '__main__':
    main()
