"""The scenes of the bench. Each maker takes its size and gives a Scene; the same size gives the same scene always."""
import math
import random
from itertools import product

from formats import Look, Scene, vector
from geometry import add, around, scaled, unit
import shapes
import solids

PALETTE = ((.85, .35, .25), (.3, .7, .35), (.3, .45, .85), (.85, .75, .3), (.7, .4, .75), (.35, .75, .8))
MATT = tuple(Look(rgb) for rgb in PALETTE)
SHINY = tuple(Look(rgb, reflection=0.3) for rgb in PALETTE)
UPRIGHT = (0.0, 1.0, 0.0)


def flake(depth):
    """A sphereflake: nine spheres of a third of the size on each, six around it and three on top."""
    def grow(centre, radius, axis, level):
        yield (*centre, radius, level % len(PALETTE))
        if level == depth:
            return
        for number in range(9):
            height, turn = (0.0, number) if number < 6 else (math.sqrt(2.0 / 3.0), 2 * number + 0.5)
            out = around(axis, height, turn * math.pi / 3.0)
            yield from grow(add(centre, scaled(out, radius * 4.0 / 3.0)), radius / 3.0, out, level + 1)
    return Scene((2.1, 1.7, -4.2), (0, 0.15, 0), 42, looks=SHINY,
                 spheres=lambda: grow((0.0, 0.0, 0.0), 1.0, UPRIGHT, 0))


def spheres(count):
    """Spheres strewn in a cube, every other one a mirror."""
    def strew():
        draw = random.Random(count).random
        spacing = 2.0 / count ** (1.0 / 3.0)
        for _ in range(count):
            place = [2.0 * draw() - 1.0 for _ in range(3)]
            radius = spacing * (0.15 + 0.3 * draw())
            yield (*place, radius, int(draw() * 12.0))
    return Scene((1.9, 1.5, -3.6), (0, 0, 0), 42, looks=MATT + SHINY, spheres=strew)


SHAPES = (
    'sphere { <0,0,0>, .8',
    'box { <-.6,-.6,-.6>, <.6,.6,.6>',
    'cone { <0,-.8,0>, .7, <0,.8,0>, .2',
    'cylinder { <0,-.7,0>, <0,.7,0>, .5',
    'quadric { <2,1,3>, <0,0,0>, <0,0,0>, -.8',
    'polygon { 6, <-.7,-.7,0>, <.7,-.7,0>, <.9,.3,0>, <0,.9,0>, <-.9,.3,0>, <-.7,-.7,0>',
)
GLASS = Look((.9, .95, .95), filter=0.8, ior=1.3)
MIRROR = Look((.4, .4, .45), reflection=0.6)


def placed(shape, look, turn, size, place):
    return (f'{shape} {look.text()} rotate <%.5g,%.5g,%.5g> scale <%.5g,%.5g,%.5g> translate {vector(place)} }}'
            % (*turn, *size))


def mixed(count):
    """All primitives, each turned, stretched and moved; a fifth are mirrors, an eighth is glass.

    Quadrics are not turned: POV-Ray finds no box around one that is, and would ask it of every ray.
    """
    def strew():
        draw = random.Random(count + 1).random
        spacing = 2.0 / count ** (1.0 / 3.0)
        for number in range(count):
            place = [2.0 * draw() - 1.0 for _ in range(3)]
            turn = [360.0 * draw() for _ in range(3)]
            if SHAPES[number % 6].startswith('quadric'):
                turn = [0.0, 0.0, 0.0]
            size = [spacing * (0.2 + 0.35 * draw()) for _ in range(3)]
            kind = draw()
            look = MIRROR if kind < 0.2 else GLASS if kind < 0.325 else MATT[int(draw() * 6.0)]
            yield placed(SHAPES[number % 6], look, turn, size, place)
    return Scene((1.9, 1.5, -3.6), (0, 0, 0), 42, objects=strew)


def floor(half, look=Look((.7, .7, .65))):
    return f'box {{ <{-half:g},-.1,{-half:g}>, <{half:g},0,{half:g}> {look.text()} }}'


def rings(side):
    """Chain mail: rings of twelve cylinders with spheres at the joints, each hooked into its neighbours."""
    def ring(centre, axis, radius, thick, look):
        corners = [add(centre, scaled(around(axis, 0.0, turn * math.pi / 6.0), radius)) for turn in range(12)]
        for here, there in zip(corners, corners[1:] + corners[:1]):
            yield f'cylinder {{ {vector(here)}, {vector(there)}, {thick:g} {look.text()} }}'
            yield f'sphere {{ {vector(here)}, {1.3 * thick:g} {look.text()} }}'

    def weave():
        yield floor(4)
        step = 3.0 / side
        for x, z in product(range(side), range(side)):
            axis = unit((0.5 if (x + z) % 2 else -0.5, 1.0, 0.4 if x % 2 else -0.4))
            centre = ((x + 0.5) * step - 1.5, 0.5 * step + 0.25 * math.sin(3.0 * x * step), (z + 0.5) * step - 1.5)
            yield from ring(add(centre, (0, 0.3, 0)), axis, 0.62 * step, 0.07 * step, SHINY[(x + 2 * z) % 6])
    return Scene((1.6, 2.6, -3.4), (0, 0.3, 0), 42, objects=weave)


def tree(depth):
    """Three cones out of the end of each, a sphere at every joint, over a floor."""
    def grow(foot, axis, length, radius, level):
        tip = add(foot, scaled(axis, length))
        look = MATT[0 if level < depth - 2 else 1]
        yield f'cone {{ {vector(foot)}, {radius:.5g}, {vector(tip)}, {0.6 * radius:.5g} {look.text()} }}'
        yield f'sphere {{ {vector(tip)}, {0.62 * radius:.5g} {look.text()} }}'
        if level == depth:
            return
        for number in range(3):
            out = around(axis, 0.72, 2.0 * math.pi * number / 3.0 + 0.7 * level)
            yield from grow(tip, out, 0.68 * length, 0.58 * radius, level + 1)

    def stand():
        yield floor(8)
        yield from grow((0.0, 0.0, 0.0), UPRIGHT, 0.9, 0.12, 1)
    return Scene((0.4, 1.9, -5.2), (0, 1.2, 0), 42, objects=stand)


def hall(columns):
    """A closed hall whose walls are mirrors, with columns and spheres: most rays are mirrored ones."""
    wall = Look((.05, .05, .06), reflection=0.8)
    loops = (((-4, 0, -5), (-4, 3, -5), (-4, 3, 5), (-4, 0, 5)), ((4, 0, -5), (4, 3, -5), (4, 3, 5), (4, 0, 5)),
             ((-4, 0, 5), (-4, 3, 5), (4, 3, 5), (4, 0, 5)), ((-4, 0, -5), (-4, 3, -5), (4, 3, -5), (4, 0, -5)))

    def build():
        for loop in loops:
            yield 'polygon { 5, ' + ', '.join(vector(v) for v in loop + loop[:1]) + f' {wall.text()} }}'
        yield floor(6, Look((.6, .55, .5), reflection=0.15))
        yield f'box {{ <-6,3,-6>, <6,3.2,6> {Look((.8, .8, .8)).text()} }}'
        for number in range(columns):
            x, z = (-2.6, 2.6)[number % 2], 4.0 * (number // 2 + 0.5) / (columns // 2) * 2.0 - 4.0
            look = MATT[number % 6].text()
            yield f'cylinder {{ <{x:g},.25,{z:.5g}>, <{x:g},2.6,{z:.5g}>, .18 {look} }}'
            yield f'cone {{ <{x:g},2.6,{z:.5g}>, .18, <{x:g},3,{z:.5g}>, .42 {look} }}'
            yield f'box {{ <{x - .3:g},0,{z - .3:.5g}>, <{x + .3:g},.25,{z + .3:.5g}> {look} }}'
            yield f'sphere {{ <{x * .45:g},.4,{z:.5g}>, .4 {MIRROR.text()} }}'
    return Scene((0.5, 1.5, -4.4), (-0.6, 1.1, 0), 70, lights=[((0, 2.8, -2), 0.5), ((1, 2.8, 3), 0.5)],
                 max_trace_level=20, objects=build)


def glass(side):
    """Spheres, lenses and bars of glass over a floor of tiles: refraction, inner reflection, coloured shadows."""
    kinds = ('sphere { <0,.5,0>, .45', 'quadric { <8,2,8>, <0,0,0>, <0,-2,0>, 0', 'box { <-.3,.05,-.3>, <.3,.9,.3>',
             'cylinder { <0,.05,0>, <0,.95,0>, .33', 'cone { <0,.05,0>, .45, <0,1,0>, .1')

    def lay():
        for x, z in product(range(-side, side), range(-side, side)):
            look = Look((.75, .75, .7) if (x + z) % 2 else PALETTE[(x * 5 + z * 3) % 6])
            yield f'box {{ <{x:g},-.1,{z:g}>, <{x + 1:g},0,{z + 1:g}> {look.text()} }}'
        for number, (x, z) in enumerate(product(range(side), range(side))):
            rgb = tuple(0.7 + 0.3 * c for c in PALETTE[number % 6])
            look = Look(rgb, filter=0.9, ior=1.5, reflection=0.08)
            place = (1.3 * x - 0.65 * (side - 1), 0.0, 1.3 * z - 0.65 * (side - 1))
            yield placed(kinds[number % 5], look, (0, 37 * number % 360, 0), (1, 1, 1), place)
    return Scene((2.0, 3.6, -7.5), (0, 0.3, 0), 42, max_trace_level=10, objects=lay)


def strip(count):
    """A railway to the horizon: rails and wires a thousand long and a thumb wide, gravel, posts; long, thin, uneven."""
    def lay():
        draw = random.Random(count + 2).random
        yield floor(2000, Look((.35, .45, .25)))
        for x in (-0.72, 0.72):
            yield f'box {{ <{x - .04:g},.18,-10>, <{x + .04:g},.32,1000> {Look((.5, .5, .55), reflection=.3).text()} }}'
        for number in range(12):
            x, y = -4.0 + 8.0 * draw(), 5.0 + 2.0 * draw()
            yield (f'cylinder {{ <{x:.4g},{y:.4g},-10>, <{x + 6 * draw() - 3:.4g},{y + 4 * draw():.4g},1000>, .02 '
                   f'{MATT[number % 6].text()} }}')
        for number in range(count // 20):
            z = 0.65 * number - 8.0
            yield f'box {{ <-1.3,0,{z:.6g}>, <1.3,.18,{z + .26:.6g}> {MATT[0].text()} }}'
            if number % 40 == 0:
                yield f'cylinder {{ <-2.6,0,{z:.6g}>, <-2.6,7.5,{z:.6g}>, .09 {MATT[3].text()} }}'
                yield f'cone {{ <-2.6,7.5,{z:.6g}>, .09, <0,7.2,{z:.6g}>, .03 {MATT[3].text()} }}'
        for number in range(count):
            distance = 400.0 * draw() ** 3
            size = 0.03 + 0.05 * draw()
            place = (4.0 * draw() - 2.0, size * 0.5, distance - 6.0)
            yield f'sphere {{ {vector(place)}, {size:.4g} {MATT[number % 6].text()} }}'
    return Scene((1.1, 1.5, -7.0), (-0.3, 0.7, 6), 50, lights=[((40, 60, -30), 0.7), ((-30, 40, -10), 0.3)],
                 background=(.5, .6, .8), objects=lay)


def pair(kind):
    """A thousand matt spheres, and the same with one feature more: what the feature costs everything else."""
    def strew():
        draw = random.Random(11).random
        for number in range(1000):
            place = [2.0 * draw() - 1.0 for _ in range(3)]
            radius = 0.2 * (0.15 + 0.3 * draw())
            look = MATT[number % 6]
            if number % 100 == 0 and kind in ('mirror', 'filter', 'glass'):
                look = {'mirror': MIRROR, 'filter': Look((.9, .9, .9), filter=0.8), 'glass': GLASS}[kind]
            moved = kind == 'moved' and number % 100 == 0
            shape = f'sphere {{ {vector((0, 0, 0) if moved else place)}, {radius:.5g} {look.text()}'
            yield shape + (f' scale <1,.7,1> rotate <0,0,30> translate {vector(place)} }}' if moved else ' }')
    lights = [((4, 6, -5), 0.7), ((-6, 3, -3), 0.3)]
    return Scene((1.9, 1.5, -3.6), (0, 0, 0), 42, lights=lights[:2 if kind == 'light' else 1], objects=strew)


def moved(kind):
    """Unit spheres, each brought to its place: "even" ones keep their shape, others are stretched and turned."""
    def make(count):
        def strew():
            draw = random.Random(count + 3).random
            spacing = 2.0 / count ** (1.0 / 3.0)
            for _ in range(count):
                place = [2.0 * draw() - 1.0 for _ in range(3)]
                size = [spacing * (0.15 + 0.3 * draw()) for _ in range(3)]
                turn = [360.0 * draw() for _ in range(3)]
                look = MATT[int(draw() * 6.0)].text()
                change = '%.5g' % size[0] if kind == 'even' else '<%.5g,%.5g,%.5g> rotate <%.5g,%.5g,%.5g>' % (*size, *turn)
                yield f'sphere {{ <0,0,0>, 1 {look} scale {change} translate {vector(place)} }}'
        return Scene((1.9, 1.5, -3.6), (0, 0, 0), 42, objects=strew)
    return make


STONE = 'color_map { [0 rgb <.9,.85,.7>] [.4 rgb <.7,.3,.2>] [.7 rgb <.4,.2,.3>] [1 rgb <.1,.1,.2>] }'
WATER = 'pigment { rgb <.2,.3,.4> } finish { reflection .6 phong .3 }'
VEIL = 'color_map { [0 rgbt <.9,.8,.7,1>] [.6 rgbt <%g,.4,.2,.5>] [1 rgb <.2,.2,.2>] } scale %g'


def plain(pigment):
    return f'texture {{ pigment {{ {pigment} }} }}'


def water(normal):
    return f'texture {{ {WATER} normal {{ {normal} }} }}'


TEXTURES = {
    'bozo': plain(f'bozo turbulence .6 {STONE} scale .3'),
    'granite': plain(f'granite {STONE} scale .8'),
    'agate': plain(f'agate {STONE} scale .5'),
    'marble': plain(f'marble turbulence .8 {STONE} scale .4'),
    'wood': plain(f'wood turbulence .1 {STONE} scale .2 rotate <20,30,0>'),
    'layers': ' '.join((plain(f'granite {STONE}'), plain('agate ' + VEIL % (0, .2)),
                        plain('bozo turbulence .5 ' + VEIL % (.1, .3)), plain('marble turbulence 1 ' + VEIL % (.2, .4)))),
    'crackle': ' '.join((plain('checker rgb 1 rgb <.2,.3,.5> scale .3'),
                         *(plain('crackle ' + VEIL % (.1 * layer, .2 + .05 * layer)) for layer in range(10)))),
    'image': plain('image_map { function 256,256 { pattern { agate scale .3 } } interpolate 2 } scale .7 rotate x*90'),
    'bumps': water('bumps .4 scale .1'),
    'ripples': water('ripples .4 frequency 2 scale .3'),
}


def textured(kind):
    """Spheres on a floor, all of one texture."""
    def lay():
        text = TEXTURES[kind]
        yield f'box {{ <-8,-.1,-8>, <8,0,8> {text} }}'
        for x, z in product(range(5), range(5)):
            yield f'sphere {{ <{x - 2:g},.45,{z - 2:g}>, .45 {text} }}'
    return Scene((2.0, 3.0, -5.5), (0, 0.2, 0), 42, objects=lay)


LAMP = 'light_source { <6,10,-8> rgb 1 %s }'
CLAY = 'pigment { rgb <.8,.5,.3> } finish { phong .4 ambient .05 }'
# The lights and the air, and what all objects are made of.
LIT = {
    'area': (LAMP % 'area_light 2*x, 2*z, 8, 8', CLAY),
    'spot': (LAMP % 'spotlight point_at 0 radius 10 falloff 20 fade_distance 9 fade_power 2', CLAY),
    'fog': (LAMP % '' + ' fog { distance 10 rgb .7 } fog { fog_type 2 distance 4 fog_offset .2 fog_alt .3 rgb .6 }', CLAY),
    'fresnel': (LAMP % '', 'pigment { rgbt .95 } finish { reflection { 0 1 fresnel } conserve_energy specular .5 '
                           'roughness .01 } interior { ior 1.5 }'),
    'layered': (LAMP % '', 'texture { pigment { rgb <.7,.4,.2> } finish { specular .4 diffuse .6 } } '
                           'texture { pigment { rgbt <1,.9,.8,.5> } finish { phong .7 phong_size 80 reflection .1 brilliance 2 } }'),
    'metal': (LAMP % '', 'pigment { rgb <.8,.6,.2> } finish { ambient .1 diffuse .4 brilliance 3 specular .8 roughness .02 '
                         'metallic reflection { .4 metallic } }'),
}


def lit(kind):
    """Spheres on a floor in some light."""
    light, text = LIT[kind]

    def lay():
        yield light
        yield f'box {{ <-8,-.1,-8>, <8,0,8> {text} }}'
        for x, z in product(range(5), range(5)):
            yield f'sphere {{ <{x - 2:g},.45,{z - 2:g}>, .45 {text} }}'
    return Scene((2.0, 3.0, -5.5), (0, 0.2, 0), 42, lights=[], background=(.4, .5, .7), objects=lay)


PAIRS = ('plain', 'mirror', 'filter', 'glass', 'moved', 'light')
def forest(copies):
    """Copies of one declared union of 100 000 leaves, each turned and moved: memory should grow by the copies only."""
    def grow():
        draw = random.Random(2).random
        yield '#declare Tree = union {'
        for _ in range(100000):
            height, out, turn = draw(), draw(), 2.0 * math.pi * draw()
            reach = 0.45 * (1.0 - height) * math.sqrt(out)
            yield f'  sphere {{ {vector((reach * math.cos(turn), height, reach * math.sin(turn)))}, .006 }}'
        yield '  pigment { rgb <.2,.5,.15> } }'
        for _ in range(copies):
            yield (f'object {{ Tree rotate <0,{360.0 * draw():.5g},0> '
                   f'translate {vector((80.0 * draw() - 40.0, 0.0, 80.0 * draw()))} }}')
    return Scene((0, 6, -12), (0, 0, 14), 50, looks=MATT, objects=grow)


MAKERS = {'flake': (flake, 4), 'forest': (forest, 10000), 'spheres': (spheres, 1000), 'mixed': (mixed, 1000), 'rings': (rings, 14),
          'tree': (tree, 8), 'hall': (hall, 12), 'glass': (glass, 7), 'strip': (strip, 20000),
          'moved': (moved('even'), 1000), 'stretched': (moved('stretched'), 1000),
          'csg': (solids.csg(True), 1000), 'csg_dark': (solids.csg(False), 1000),
          'csg_turned': (solids.csg(True, True), 1000), 'bored': (solids.bored, 10000),
          'tori': (solids.tori(True), 500), 'tori_dark': (solids.tori(False), 500), 'mesh': (solids.mesh, 1000000)}
TEXTURED = tuple('texture-' + kind for kind in TEXTURES)
KINDS = tuple('shape-' + kind for kind in shapes.SHAPES)
LIGHTS = tuple('light-' + kind for kind in LIT)
BENCH = ('flake-4', 'flake-6', 'spheres-1e2', 'spheres-1e4', 'spheres-1e5', 'spheres-1e6', 'mixed-1e2', 'mixed-1e4',
         'mixed-1e5', 'rings', 'tree', 'hall', 'glass', 'strip', *TEXTURED, *LIGHTS)


def scene(name):
    """By its name: a maker's, and behind a dash its size where it is not the usual one."""
    kind, _, size = name.partition('-')
    if kind == 'pair' and size in PAIRS:
        return pair(size)
    if kind == 'texture' and size in TEXTURES:
        return textured(size)
    if kind == 'light' and size in LIT:
        return lit(size)
    if kind == 'shape' and size in shapes.SHAPES:
        return shapes.shape(size)
    if kind not in MAKERS:
        every = [*MAKERS, *('pair-' + kind for kind in PAIRS), *TEXTURED, *LIGHTS, *KINDS]
        raise ValueError(f'no scene "{name}"; there are {", ".join(every)}')
    maker, usual = MAKERS[kind]
    return maker(int(float(size)) if size else usual)
