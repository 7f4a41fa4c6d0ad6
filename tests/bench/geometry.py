"""Three-vectors as tuples: the little that the scene makers need."""
import math


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scaled(a, k):
    return (a[0] * k, a[1] * k, a[2] * k)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return scaled(a, 1.0 / math.sqrt(dot(a, a)))


def frame(axis):
    """Two unit vectors that stand upright on a unit axis and on each other."""
    helper = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.6 else (0.0, 1.0, 0.0)
    first = unit(cross(helper, axis))
    return first, cross(axis, first)


def around(axis, height, turn):
    """The unit vector that leans from the equator of `axis` by height (a sine), turned about it by `turn` radians."""
    first, second = frame(axis)
    level = math.sqrt(max(0.0, 1.0 - height * height))
    return add(scaled(axis, height),
               add(scaled(first, level * math.cos(turn)), scaled(second, level * math.sin(turn))))
