"""Curves of the bench: panels with logarithmic axes side by side, a line with its own mark for each series."""
import math

import chart

WIDE, HIGH, GAP, BELOW = 300, 240, 70, 60


class Axis:
    """A logarithmic axis from the least to the largest of the values, with a little room."""

    def __init__(self, values, at, length):
        self.low, self.high = min(values), max(values)
        if self.high < 2.0 * self.low:
            self.low, self.high = self.low / 1.5, self.high * 1.5
        self.at, self.length = at, length

    def __call__(self, value):
        return self.at + self.length * math.log(value / self.low) / math.log(self.high / self.low)

    def ticks(self):
        """1, 2 and 5 of each decade; the decades alone where that would be many."""
        many = self.high / self.low > 300.0
        return [value for value in chart.ticks(self.low, self.high) if not many or f'{value:e}'.startswith('1.0')]


def short(value):
    return f'{value:g}' if 1e-3 <= value < 1e4 else f'{value:.0e}'.replace('e+0', 'e').replace('e-0', 'e-')


def panel(left, title, across, series):
    """One diagram; series is a list of (name, [(x, y), ...])."""
    points = [point for _, line in series for point in line if point[0] > 0 and point[1] > 0]
    x, y = Axis([p[0] for p in points], left, WIDE), Axis([p[1] for p in points], 60 + HIGH, -HIGH)
    parts = [chart.text(left, 48, title, size=13)]
    for value in x.ticks():
        parts += [f'<path d="M{x(value):.1f} 60 v{HIGH}" stroke="#ddd"/>',
                  chart.text(x(value), 60 + HIGH + 16, short(value), 'middle', 11)]
    for value in y.ticks():
        parts += [f'<path d="M{left} {y(value):.1f} h{WIDE}" stroke="#ddd"/>',
                  chart.text(left - 6, y(value) + 4, short(value), 'end', 11)]
    parts.append(chart.text(left + WIDE / 2, 60 + HIGH + 34, across, 'middle', 12))
    for number, (_, line) in enumerate(series):
        colour, form = chart.STYLES[1 + number % (len(chart.STYLES) - 1)]
        places = [(x(px), y(py)) for px, py in line if px > 0 and py > 0]
        parts.append(f'<polyline fill="none" stroke="{colour}" stroke-width="1.5" points="'
                     + ' '.join(f'{px:.1f},{py:.1f}' for px, py in places) + '"/>')
        parts += [chart.mark(form, colour, px, py) for px, py in places]
    return parts


def draw(title, across, panels):
    """An SVG's text; panels is a list of (title, series). All panels have the series of the first."""
    width, height = (WIDE + GAP) * len(panels) + 30, HIGH + 60 + BELOW
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif">',
             f'<rect width="{width}" height="{height}" fill="white"/>', chart.text(GAP, 22, title, size=15)]
    for number, (name, series) in enumerate(panels):
        parts += panel(GAP + number * (WIDE + GAP), name, across, series)
    for number, (name, _) in enumerate(panels[0][1]):
        colour, form = chart.STYLES[1 + number % (len(chart.STYLES) - 1)]
        parts += [chart.mark(form, colour, GAP + 8 + 130 * number, height - 12),
                  chart.text(GAP + 20 + 130 * number, height - 8, name, size=12)]
    return '\n'.join(parts + ['</svg>', ''])
