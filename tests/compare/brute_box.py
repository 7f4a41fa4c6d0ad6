#!/usr/bin/env python3
"""A box of diffuse walls after exactly three bounces by brute force, beside pictures of povc and POV-Ray.

The boxes are rad_box_empty, rad_box_sky and the one with glass of a folder of probes: walls of .7, the left one red, the right
one green, lit by a patch under the ceiling, or open above to an even sky, or with a sphere of glass that lets .9 through at each
surface. Paths are followed with numpy and know nothing of povtrace. Printed are,
over the means of 8x8 pixels none of which is nearly clipped, by how much both pictures are off."""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import images
import numpy

WIDTH, HEIGHT, BLOCK = 64, 48, 8
BOUNCES = 3
SKY, EMISSION, PATCH_AT, PATCH_HALF = (.4, .5, .7), 3.0, .999, .5
TOP = 3
CENTRE, RADIUS, IOR, CLEAR = numpy.array([.2, -.5, .3]), .45, 1.5, .9
# By face: -x, +x, -y, +y, -z, +z.
ALBEDO = .7 * numpy.array([[.9, .2, .2], [.2, .9, .2]] + 4 * [[1, 1, 1]])


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('probes', type=Path, help='the folder, with ref/')
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--samples', default='1024', help='of povc, a pixel')
    parser.add_argument('--paths', type=int, default=4000, help='of a pixel')
    return parser.parse_args()


def camera_rays(random):
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    u = ((x + random.random(x.shape)) / WIDTH - .5).ravel()
    v = (.5 - (y + random.random(y.shape)) / HEIGHT).ravel()
    direction = numpy.stack([2 * u, 1.5 * v, numpy.full(u.shape, .75)], 1)
    return numpy.tile([0, 0, -.95], (len(u), 1)), direction / numpy.linalg.norm(direction, axis=1)[:, None]


def walls(start, direction):
    """Where rays leave the box -1..1: the face, the point and the parameter."""
    every = numpy.arange(len(start))
    with numpy.errstate(divide='ignore', invalid='ignore'):
        t = numpy.where(direction > 0, (1 - start) / direction, numpy.where(direction < 0, (-1 - start) / direction, numpy.inf))
    t = numpy.where(t > 1e-12, t, numpy.inf)
    axis = t.argmin(1)
    up = direction[every, axis] > 0
    point = start + t[every, axis][:, None] * direction
    point[every, axis] = numpy.where(up, 1., -1.)
    return 2 * axis + up, point, t[every, axis]


def normals(face):
    out = numpy.zeros((len(face), 3))
    out[numpy.arange(len(face)), face // 2] = numpy.where(face % 2, -1., 1.)
    return out


def hits_patch(start, direction, until):
    with numpy.errstate(divide='ignore', invalid='ignore'):
        t = (PATCH_AT - start[:, 1]) / direction[:, 1]
    at = start + t[:, None] * direction
    return (t > 1e-9) & (t < until) & (abs(at[:, 0]) < PATCH_HALF) & (abs(at[:, 2]) < PATCH_HALF)


def refracted(direction, normal, eta):
    """Through a surface whose normal faces the ray."""
    cosine = -(direction * normal).sum(1)[:, None]
    return eta * direction + (eta * cosine - numpy.sqrt(1 - eta * eta * (1 - cosine * cosine))) * normal


def through_sphere(start, direction, until):
    """The rays behind the sphere, and what it leaves of them."""
    b = ((start - CENTRE) * direction).sum(1)
    square = b * b - ((start - CENTRE) ** 2).sum(1) + RADIUS ** 2
    near = -b - numpy.sqrt(numpy.maximum(square, 0))
    meets = (square > 0) & (near > 1e-9) & ~hits_patch(start, direction, numpy.minimum(near, until))
    enters = start + near[:, None] * direction
    normal = (enters - CENTRE) / RADIUS
    normal[~meets] = -direction[~meets]
    inside = refracted(direction, normal, 1 / IOR)
    leaves = enters - 2 * RADIUS * (inside * normal).sum(1)[:, None] * inside
    behind = refracted(inside, -(leaves - CENTRE) / RADIUS, IOR)
    meets = meets[:, None]
    return numpy.where(meets, leaves, start), numpy.where(meets, behind, direction), numpy.where(meets, CLEAR ** 2, 1)


def scattered(random, normal):
    """Directions by the cosine."""
    u, turn = random.random(len(normal)), 2 * numpy.pi * random.random(len(normal))
    other = numpy.where(abs(normal[:, :1]) > .5, [[0, 1., 0]], [[1., 0, 0]])
    a = numpy.cross(normal, other)
    b = numpy.cross(normal, a)
    radius = numpy.sqrt(u)
    return (radius * numpy.cos(turn))[:, None] * a + (radius * numpy.sin(turn))[:, None] * b + numpy.sqrt(1 - u)[:, None] * normal


def from_patch(random, face, point, normal):
    """What one random point of the patch, which shines to both sides, gives; above it hides itself."""
    count = len(point)
    at = numpy.stack([random.random(count) - .5, numpy.full(count, PATCH_AT), random.random(count) - .5], 1)
    way = at - point
    square = (way * way).sum(1)
    cosine = (way * normal).sum(1)
    above = (face == TOP) & (abs(point[:, 0]) < PATCH_HALF) & (abs(point[:, 2]) < PATCH_HALF)
    return numpy.where((cosine > 0) & ~above, EMISSION * cosine * abs(way[:, 1]) / (numpy.pi * square ** 2), 0)


def one_path_each(random, name):
    sky, glass = name.endswith('sky'), 'glass' in name
    start, direction = camera_rays(random)
    out, weight = numpy.zeros(start.shape), numpy.ones(start.shape)
    alive = numpy.ones(len(start), bool)
    for bounce in range(BOUNCES + 1):
        face, point, until = walls(start, direction)
        if glass:
            start, direction, left = through_sphere(start, direction, until)
            weight = weight * left
            face, point, until = walls(start, direction)
        gone = alive & (face == TOP if sky else hits_patch(start, direction, until))
        if sky or glass or bounce == 0:
            out += weight * gone[:, None] * (numpy.array(SKY) if sky else EMISSION)
        alive &= ~gone
        if bounce == BOUNCES:
            break
        normal = normals(face)
        weight = weight * ALBEDO[face]
        if not sky and not glass:
            out += weight * (from_patch(random, face, point, normal) * alive)[:, None]
        start, direction = point, scattered(random, normal)
    return out.reshape(HEIGHT, WIDTH, 3)


def blocks(picture):
    return picture.reshape(HEIGHT // BLOCK, BLOCK, WIDTH // BLOCK, BLOCK, 3)


def means(picture):
    return blocks(picture).mean((1, 3))


def main():
    options = arguments()
    random = numpy.random.default_rng(5)
    for name in ('rad_box_empty', 'rad_box_sky', "rad_box_glass_ball"):
        truth = sum(one_path_each(random, name) for _ in range(options.paths)) / options.paths
        counts = blocks(truth).max((1, 3, 4)) < .9
        with tempfile.TemporaryDirectory() as work:
            ours = Path(work, 'ours.pfm')
            subprocess.run([options.povc, options.probes / f'{name}.pov', '-s', f'{WIDTH}x{HEIGHT}', '-o', ours, '--spp', options.samples,
                            '--sampling', 'uniform', '-q'], check=True)
            pictures = {'povc': images.read_pfm(ours), 'POV-Ray': images.read_png(options.probes / f'ref/{name}.png')}
        for program, picture in pictures.items():
            off = (means(numpy.clip(picture, 0, 1)) / means(truth) - 1)[counts]
            print(f'{name} {program:8} rms {100 * (off ** 2).mean() ** .5:.2f} %, worst {100 * abs(off).max():.2f} %, '
                  f'mean {100 * off.mean():+.2f} % of {counts.sum()} means', flush=True)


if __name__ == '__main__':
    sys.exit(main())
