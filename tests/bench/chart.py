"""The bench's picture: a row for each scene, a mark for each program, how many times as long as the first program."""
import math
from xml.sax.saxutils import escape

# Okabe and Ito's colours, each with a form of its own: told apart in print and by the colour-blind.
STYLES = (('#000000', 'line'), ('#d55e00', 'circle'), ('#0072b2', 'square'), ('#009e73', 'triangle'),
          ('#cc79a7', 'diamond'), ('#e69f00', 'cross'))
LEFT, RIGHT, TOP, ROW = 130, 30, 70, 26


class Scale:
    """A logarithmic axis from `low` to `high` over `width` pixels from LEFT."""

    def __init__(self, low, high, width):
        self.low, self.high, self.width = math.log(low), math.log(high), width

    def __call__(self, value):
        return LEFT + self.width * (math.log(value) - self.low) / (self.high - self.low)


def mark(form, colour, x, y):
    r = 5
    shapes = {'circle': f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}"',
              'square': f'<rect x="{x - r:.1f}" y="{y - r:.1f}" width="{2 * r}" height="{2 * r}"',
              'triangle': f'<path d="M{x:.1f} {y - r:.1f} l{r} {2 * r} h{-2 * r} z"',
              'diamond': f'<path d="M{x:.1f} {y - r - 1:.1f} l{r} {r + 1} l{-r} {r + 1} l{-r} {-r - 1} z"',
              'cross': f'<path d="M{x - r:.1f} {y - r:.1f} l{2 * r} {2 * r} m0 {-2 * r} l{-2 * r} {2 * r}"',
              'line': f'<path d="M{x:.1f} {y - ROW / 2:.1f} v{ROW}"'}
    stroke = f' fill="none" stroke="{colour}" stroke-width="2"'
    return shapes[form] + (stroke if form in ('cross', 'line') else f' fill="{colour}"') + '/>'


def text(x, y, words, anchor='start', size=13, colour='#222'):
    style = f'text-anchor="{anchor}" font-size="{size}" fill="{colour}"'
    return f'<text x="{x:.1f}" y="{y:.1f}" {style}>{escape(words)}</text>'


def ticks(low, high):
    """1, 2 and 5 of each decade."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    return [m * 10.0 ** d for d in decades for m in (1, 2, 5) if low <= m * 10.0 ** d <= high]


def draw(title, programs, rows):
    """An SVG's text. Rows are (scene, {program: ratio}); the first program is the measure, at 1."""
    values = [ratio for _, ratios in rows for ratio in ratios.values()] + [1.0]
    low, high = min(values) * 0.85, max(values) * 1.2
    width, height = 760, TOP + ROW * len(rows) + 40
    scale = Scale(low, high, width - LEFT - RIGHT)
    bottom = TOP + ROW * len(rows)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>', text(LEFT, 22, title, size=15)]
    for value in ticks(low, high):
        x = scale(value)
        parts.append(f'<path d="M{x:.1f} {TOP} V{bottom}" stroke="#ddd"/>')
        parts.append(text(x, bottom + 16, f'{value:g}', 'middle', 12))
    parts.append(text(LEFT, bottom + 34, f'trace time, {programs[0]} = 1', size=12))
    for number, program in enumerate(programs):
        colour, form = STYLES[number % len(STYLES)]
        x = LEFT + 8 + number * (width - LEFT - RIGHT) / len(programs)
        parts += [mark(form, colour, x, 46), text(x + 12, 50, program, size=12)]
    for number, (scene, ratios) in enumerate(rows):
        y = TOP + ROW * (number + 0.5)
        parts += [text(LEFT - 10, y + 4, scene, 'end'),
                  f'<path d="M{LEFT} {y:.1f} H{width - RIGHT}" stroke="#eee"/>']
        parts += [mark(STYLES[place % len(STYLES)][1], STYLES[place % len(STYLES)][0], scale(ratios[program]), y)
                  for place, program in enumerate(programs) if program in ratios]
    return '\n'.join(parts + ['</svg>', ''])
