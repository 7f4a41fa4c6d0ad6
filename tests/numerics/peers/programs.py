"""The same scene in each program's own language, and the picture that comes of it as rows of numbers (red)."""
import math
import os
import struct
import subprocess

import exact


class Missing(Exception):
    """The program is not there, or cannot draw this."""


def vector(v):
    return '<%s>' % ','.join('%.17g' % x for x in v)


def povray_shape(kind, size, c):
    """size: a factor; c: where the centre stands. Plain coordinates, as a user would write them."""
    def at(x, y, z):
        return vector((x * size + c[0], y * size + c[1], z * size + c[2]))
    if kind == 'sphere':
        return 'sphere { %s, %.17g' % (at(0, 0, 0), size)
    if kind == 'box':
        x, y, z = exact.BOX
        return 'box { %s, %s' % (at(-x, -y, -z), at(x, y, z))
    if kind == 'cylinder':
        h = exact.CYLINDER_HALF
        return 'cylinder { %s, %s, %.17g' % (at(0, -h, 0), at(0, h, 0), exact.CYLINDER_RADIUS * size)
    if kind == 'cone':
        h = exact.CONE_HALF
        return 'cone { %s, %.17g, %s, 0' % (at(0, -h, 0), exact.CONE_BASE * size, at(0, h, 0))
    if kind == 'polygon':
        corners = [at(x, y, 0) for x, y in exact.TRIANGLE + exact.TRIANGLE[:1]]
        return 'polygon { 4, %s' % ', '.join(corners)
    a, b, d, j = exact.QUADRIC
    return 'quadric { <%.17g,%.17g,%.17g>, <0,0,0>, <0,0,0>, %.17g translate %s' % (a, b, d, -j * size * size, vector(c))


def povray_text(camera, body, own_camera):
    location, direction, right, up = camera
    head = '#version 3.7; global_settings { assumed_gamma 1 max_trace_level 8 }\n'
    if own_camera:
        length = [math.sqrt(sum(x * x for x in v)) for v in (direction, right, up)]
        angle = math.degrees(2 * math.atan(length[1] / length[0] / 2))
        view = 'camera { location %s look_at %s angle %.17g right <1,0,0> up <0,1,0> }\n' % (
            vector(location), vector([a + b for a, b in zip(location, direction)]), angle)
    else:
        view = 'camera { location %s direction %s right %s up %s }\n' % tuple(
            vector(v) for v in (location, direction, right, up))
    return head + view + body


def read_netpbm(path):
    with open(path, 'rb') as file:
        data = file.read()
    words, at = [], 0
    while len(words) < 4:
        end = at
        while data[end:end + 1] not in (b' ', b'\n'):
            end += 1
        if data[at:at + 1] == b'#':
            end = data.index(b'\n', at)
        else:
            words.append(data[at:end])
        at = end + 1
    width, height = int(words[1]), int(words[2])
    if words[0] == b'PF':
        values = struct.unpack('<%df' % (3 * width * height), data[at:])[::3]
        return [list(values[y * width:(y + 1) * width]) for y in range(height)][::-1]
    top = int(words[3])
    form, step = ('>%dH', 2) if top > 255 else ('>%dB', 1)
    values = struct.unpack(form % (3 * width * height), data[at:at + 3 * step * width * height])[::3]
    return [[v / top for v in values[y * width:(y + 1) * width]] for y in range(height)]


def run(command, made):
    if os.path.exists(made):
        os.remove(made)
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=60, check=False)
    except FileNotFoundError:
        raise Missing(command[0]) from None
    if not os.path.exists(made):
        tail = done.stdout.decode('utf-8', 'replace').strip().splitlines()
        raise RuntimeError(tail[-1] if tail else 'exit %d' % done.returncode)
    return read_netpbm(made)


class PovRay:
    name = 'POV-Ray'

    def __init__(self, work, _options):
        self.work = work

    def draw(self, camera, body, n):
        scene, made = os.path.join(self.work, 'peer.pov'), os.path.join(self.work, 'povray.ppm')
        with open(scene, 'w', encoding='ascii') as file:
            file.write(povray_text(camera, body, False))
        return run(['povray', '+I' + scene, '+O' + made, '+W%d' % n, '+H%d' % n, '-A', '-D', '+FP16', 'File_Gamma=1.0',
                    '+WT1'], made)


class Povtrace:
    name = 'povtrace'

    def __init__(self, work, options):
        self.work, self.povc = work, options.povc

    def draw(self, camera, body, n):
        scene, made = os.path.join(self.work, 'own.pov'), os.path.join(self.work, 'povtrace.pfm')
        with open(scene, 'w', encoding='ascii') as file:
            file.write(povray_text(camera, body, True))
        return run([self.povc, scene, str(n), str(n), made, '-q'], made)


class Tachyon:
    name = 'Tachyon'

    def __init__(self, work, _options):
        self.work = work

    def shape(self, kind, size, c):
        def at(x, y, z):
            return '%.17g %.17g %.17g' % (x * size + c[0], y * size + c[1], z * size + c[2])
        if kind == 'sphere':
            return 'SPHERE CENTER %s RAD %.17g seen\n' % (at(0, 0, 0), size)
        if kind == 'polygon':
            return 'TRI V0 %s V1 %s V2 %s seen\n' % tuple(at(x, y, 0) for x, y in exact.TRIANGLE)
        if kind == 'cylinder':
            h = exact.CYLINDER_HALF
            return 'FCYLINDER BASE %s APEX %s RAD %.17g seen\n' % (at(0, -h, 0), at(0, h, 0),
                                                               exact.CYLINDER_RADIUS * size)
        raise Missing(kind)

    def draw_shape(self, camera, kind, size, c, n):
        location, direction, right, up = camera
        length = math.sqrt(sum(x * x for x in direction))
        half_x = math.sqrt(sum(x * x for x in right)) / length / 2
        half_y = math.sqrt(sum(x * x for x in up)) / length / 2
        aside_x, aside_y = half_x / n, half_y / n       # it looks through the corners of pixels
        scene, made = os.path.join(self.work, 'peer.dat'), os.path.join(self.work, 'tachyon.ppm')
        with open(scene, 'w', encoding='ascii') as file:
            file.write('BEGIN_SCENE\nRESOLUTION %d %d\nCAMERA\n  PROJECTION FRUSTUM\n  ZOOM 1\n  ASPECTRATIO 1\n'
                       '  ANTIALIASING 0\n  RAYDEPTH 4\n  CENTER %.17g %.17g %.17g\n  VIEWDIR %.17g %.17g %.17g\n'
                       '  UPDIR 0 1 0\n' % (n, n, *location, *direction))
            file.write('  FRUSTUM %.17g %.17g %.17g %.17g\nEND_CAMERA\nBACKGROUND 0 0 0\n' % (
                -half_x - aside_x, half_x - aside_x, -half_y - aside_y, half_y - aside_y))
            file.write('TEXDEF seen AMBIENT 1 DIFFUSE 0 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0\n')
            file.write(self.shape(kind, size, c) + 'END_SCENE\n')
        return run(['tachyon', scene, '-format', 'PPM', '-o', made, '-numthreads', '1'], made)


class Embree:
    name = 'Embree'

    def __init__(self, work, options):
        self.work, self.program = work, options.embree

    def draw_shape(self, camera, kind, size, c, n):
        if not self.program or not os.path.exists(self.program):
            raise Missing('embree')
        if kind not in ('sphere', 'box', 'polygon'):
            raise Missing(kind)
        numbers = [size, *c] + [x for v in camera for x in v]
        made = os.path.join(self.work, 'embree.ppm')
        return run([self.program, made, kind, str(n)] + ['%.17g' % x for x in numbers], made)
