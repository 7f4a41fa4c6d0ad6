"""Which rays meet a shape: exact answers, in fractions of whole numbers."""
from fractions import Fraction as F

# Shapes of the size of one about the origin; lengths are doubles on purpose.
CONE_BASE, CONE_HALF = 0.8, 0.8
CYLINDER_RADIUS, CYLINDER_HALF = 0.7, 0.8
BOX = (0.9, 0.7, 0.8)
QUADRIC = (1.0, 2.0, 1.5, 0.81)
TRIANGLE = ((-0.9, -0.8), (0.9, -0.8), (0.1, 0.9))


def exists_not_positive(a, b, c, interval):
    """Is a t^2 + 2 b t + c <= 0 somewhere in the interval (None: anywhere)?"""
    if interval is None:
        return c * a - b * b <= 0 if a > 0 else True
    low, high = interval
    places = [low, high]
    if a > 0 and low < -b / a < high:
        places.append(-b / a)
    return any((a * t + 2 * b) * t + c <= 0 for t in places)


def slab(o, d, half):
    """The interval of t with |o + t d| <= half; False: empty, None: everything."""
    if d == 0:
        return None if abs(o) <= half else False
    ends = sorted(((-half - o) / d, (half - o) / d))
    return ends[0], ends[1]


def meets_sphere(o, d, size):
    return exists_not_positive(sum(x * x for x in d), sum(x * y for x, y in zip(o, d)),
                               sum(x * x for x in o) - size * size, None)


def meets_box(o, d, size):
    low, high = None, None
    for x, v, half in zip(o, d, BOX):
        part = slab(x, v, F(half) * size)
        if part is False:
            return False
        if part is not None:
            low = part[0] if low is None else max(low, part[0])
            high = part[1] if high is None else min(high, part[1])
    return low is None or low <= high


def meets_round(o, d, half, base, slope):
    """x^2 + z^2 <= (base - slope (y + half))^2 within |y| <= half."""
    part = slab(o[1], d[1], half)
    if part is False:
        return False
    r, grow = base - slope * (o[1] + half), -slope * d[1]
    return exists_not_positive(d[0] * d[0] + d[2] * d[2] - grow * grow, d[0] * o[0] + d[2] * o[2] - grow * r,
                               o[0] * o[0] + o[2] * o[2] - r * r, part)


def meets_cylinder(o, d, size):
    return meets_round(o, d, F(CYLINDER_HALF) * size, F(CYLINDER_RADIUS) * size, F(0))


def meets_cone(o, d, size):
    half, base = F(CONE_HALF) * size, F(CONE_BASE) * size
    return meets_round(o, d, half, base, base / (2 * half))


def meets_quadric(o, d, size):
    k = [F(x) for x in QUADRIC[:3]]
    return exists_not_positive(sum(q * v * v for q, v in zip(k, d)), sum(q * v * x for q, v, x in zip(k, d, o)),
                               sum(q * x * x for q, x in zip(k, o)) - F(QUADRIC[3]) * size * size, None)


def meets_polygon(o, d, size):
    if d[2] == 0:
        return False
    t = -o[2] / d[2]
    x, y = o[0] + t * d[0], o[1] + t * d[1]
    corners = [(F(a) * size, F(b) * size) for a, b in TRIANGLE]
    turns = [(q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])
             for p, q in zip(corners, corners[1:] + corners[:1])]
    return all(turn >= 0 for turn in turns)


MEETS = {'sphere': meets_sphere, 'box': meets_box, 'cylinder': meets_cylinder, 'cone': meets_cone,
         'quadric': meets_quadric, 'polygon': meets_polygon}
NEAR_OUTLINE = F(1, 64)


def mask(kind, camera, n):
    """A row of True, False or None a line: hit, miss, or so near to the outline that a program's rounding of its
    camera may decide. The shape has the size of one and stands at the origin."""
    location, direction, right, up = ([F(x) for x in v] for v in camera)
    meets, rows = MEETS[kind], []
    for py in range(n):
        v, row = F(1, 2) - F(2 * py + 1, 2 * n), []
        for px in range(n):
            u = F(2 * px + 1, 2 * n) - F(1, 2)
            d = [a + u * b + v * c for a, b, c in zip(direction, right, up)]
            inner, outer = meets(location, d, 1 - NEAR_OUTLINE), meets(location, d, 1 + NEAR_OUTLINE)
            row.append(inner if inner == outer else None)
        rows.append(row)
    return rows


def silhouette_mask(width, n):
    """A sphere of radius 6 at the origin seen from (0, 0, -10) along (3, 0, 4), a tangent; width is the tangent of the
    angle of view. Left of the middle is a miss; the columns next to the outline are not judged."""
    rows = []
    for py in range(n):
        v, row = 5 * F(width) * (F(1, 2) - F(2 * py + 1, 2 * n)), []
        for px in range(n):
            u = F(width) * (F(2 * px + 1, 2 * n) - F(1, 2))
            d = (3 + 4 * u, v, 4 - 3 * u)
            hit = 64 * sum(x * x for x in d) <= 100 * d[2] * d[2]
            row.append(None if abs(2 * px + 1 - n) <= n // 8 else hit)
        rows.append(row)
    return rows
