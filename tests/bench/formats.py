"""Writes a scene as POV-Ray text and, where it holds nothing but opaque spheres, as Tachyon's .dat.

Both programs then send the same rays: the same camera, lights, colours and depth. All text is of the base
language, an object a line, so that files of any size are written and read as a stream.
"""
import math
from dataclasses import dataclass, field

# All but phong are the language's own defaults, so the text leaves them out.
AMBIENT, DIFFUSE, PHONG, PHONG_SIZE = 0.1, 0.6, 0.3, 40


@dataclass(frozen=True)
class Look:
    """A surface: colour, how much passes (filter), mirror, and what light inside does."""
    rgb: tuple
    reflection: float = 0.0
    filter: float = 0.0
    ior: float = 1.0

    def text(self):
        colour = 'rgb <%.3g,%.3g,%.3g>' % self.rgb
        if self.filter:
            colour = 'rgbf <%.3g,%.3g,%.3g,%.3g>' % (*self.rgb, self.filter)
        finish = f'phong {PHONG:g}'
        if self.reflection:
            finish += f' reflection {self.reflection:g}'
        inside = f' interior {{ ior {self.ior:g} }}' if self.ior != 1.0 else ''
        return f'pigment {{ {colour} }} finish {{ {finish} }}{inside}'


@dataclass
class Scene:
    """What is drawn. `spheres` gives (x, y, z, radius, number of the look); `objects` gives lines of text."""
    location: tuple
    look_at: tuple
    angle: float
    lights: list = field(default_factory=lambda: [((4, 6, -5), 0.7), ((-6, 3, -3), 0.3)])
    background: tuple = (0.05, 0.07, 0.1)
    max_trace_level: int = 5
    looks: tuple = ()
    spheres: object = None
    objects: object = None


def vector(v):
    return '<%.7g,%.7g,%.7g>' % tuple(v)


def write_povray(file, scene):
    file.write('#version 3.7;\n')
    file.write(f'global_settings {{ assumed_gamma 1 max_trace_level {scene.max_trace_level} }}\n')
    file.write(f'background {{ rgb {vector(scene.background)} }}\n')
    file.write(f'camera {{ location {vector(scene.location)} look_at {vector(scene.look_at)} '
               f'right <1.3333333333333333,0,0> up <0,1,0> angle {scene.angle:g} }}\n')
    for place, strength in scene.lights:
        file.write(f'light_source {{ {vector(place)}, rgb <{strength:g},{strength:g},{strength:g}> }}\n')
    if scene.spheres:
        ends = [f' {look.text()} }}\n' for look in scene.looks]
        for x, y, z, radius, look in scene.spheres():
            file.write('sphere { <%.6g,%.6g,%.6g>, %.6g' % (x, y, z, radius) + ends[look])
    if scene.objects:
        for line in scene.objects():
            file.write(line + '\n')


def write_tachyon(file, scene, width, height):
    """Tachyon looks through the corners of pixels, the others through their middles: half a pixel aside."""
    half_x = math.tan(math.radians(scene.angle / 2.0))
    half_y = half_x * 0.75
    aside_x, aside_y = half_x / width, half_y / height
    view = [to - at for to, at in zip(scene.look_at, scene.location)]
    file.write(f'BEGIN_SCENE\nRESOLUTION {width} {height}\nCAMERA\n  PROJECTION FRUSTUM\n  ZOOM 1\n'
               f'  ASPECTRATIO 1\n  ANTIALIASING 0\n  RAYDEPTH {scene.max_trace_level}\n')
    file.write('  CENTER %.7g %.7g %.7g\n' % tuple(scene.location))
    file.write('  VIEWDIR %.17g %.17g %.17g\n  UPDIR 0 1 0\n' % tuple(view))
    file.write('  FRUSTUM %.17g %.17g %.17g %.17g\nEND_CAMERA\n' %
               (-half_x - aside_x, half_x - aside_x, -half_y - aside_y, half_y - aside_y))
    file.write('BACKGROUND %.7g %.7g %.7g\n' % tuple(scene.background))
    for place, strength in scene.lights:
        file.write('LIGHT CENTER %.7g %.7g %.7g RAD 0.001 ' % tuple(place))
        file.write(f'COLOR {strength:g} {strength:g} {strength:g}\n')
    for number, look in enumerate(scene.looks):
        file.write(f'TEXDEF look{number} AMBIENT {AMBIENT:g} DIFFUSE {DIFFUSE:g} SPECULAR {look.reflection:g} OPACITY 1'
                   f' PHONG PLASTIC {PHONG:g} PHONG_SIZE {PHONG_SIZE:g} COLOR %.3g %.3g %.3g TEXFUNC 0\n' % look.rgb)
    for x, y, z, radius, look in scene.spheres():
        file.write('SPHERE CENTER %.6g %.6g %.6g RAD %.6g look%d\n' % (x, y, z, radius, look))
    file.write('END_SCENE\n')
