#!/usr/bin/env python3
"""Tables and plots of build/accuracy.csv, as test_primitives writes it.

    accuracy_report.py CSV DOCUMENT IMAGES PLOT

Refreshes what stands between the marks `<!-- accuracy: begin -->` and `<!-- accuracy: end -->` of the document, and draws
accuracy-work and accuracy-distance as SVG and PNG into the folder IMAGES, by the program PLOT (accuracy_plot.c).
"""
import csv
import pathlib
import subprocess
import sys

KINDS = ('sphere', 'box', 'cone', 'cylinder', 'quadric', 'polygon')
LIMITS = dict(sphere=16, box=4, cone=32, cylinder=32, quadric=16, polygon=4)
METHODS = ('certified', 'max', 'textbook', 'q-form', 'double-double')
MARKS = ('<!-- accuracy: begin -->\n', '<!-- accuracy: end -->\n')
COLUMNS = (('distance', 1.0, '1'), ('distance', 1e3, '1000'), ('distance', 1e6, '1e6'), ('distance', 1e9, '1e9'),
           ('distance', 1e12, '1e12'), ('translation', 1e9, 'moved by 1e9'), ('scale', 1e-100, 'scaled by 1e-100'),
           ('scale', 1e100, 'by 1e100'), ('grazing', -15.0, 'grazing to 1e-15'),
           ('at_surface', -14.0, 'from 1e-14 off the surface'))


def read(path):
    with open(path, newline='', encoding='utf-8') as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        for name in row:
            if name not in ('kind', 'family', 'method', 'isa', 'worst_case_hex'):
                row[name] = float(row[name])
    return rows


def chosen(rows, **wanted):
    return [row for row in rows if all(row[name] == value for name, value in wanted.items())]


def short(value):
    """Three digits, or a power of ten."""
    return f'{value:.2f}' if value < 1000 else f'{value:.0e}'.replace('e+0', 'e').replace('e+', 'e')


def millions(value):
    return f'{value / 1e6:.2f} M'


def misjudged(rows):
    return sum(row['miss_false'] + row['hit_false'] for row in rows)


def share(part, whole):
    """Of a hundred, or none at all."""
    if part == 0:
        return '0'
    return f'{100 * part / whole:.2g} %'


def product_table(rows):
    yield ('| | rays | misjudged | self-hits, leaks | median ulp | p99 | max | normal, rad | escalated, of torture '
           '| ns at distance 1000 | at 1 |')
    yield '|' + '---|' * 11
    for kind in KINDS:
        mine = chosen(rows, kind=kind, method='certified')
        near, = chosen(mine, family='distance', param=1.0)
        far, = chosen(mine, family='distance', param=1e3)
        torture, = chosen(mine, family='torture')
        yield (f'| {kind} | {millions(sum(row["n"] for row in mine))} | {misjudged(mine):.0f} '
               f'| {sum(row["selfhit"] for row in mine):.0f}, {sum(row["leak"] for row in mine):.0f} '
               f'| {max(row["t_ulp_med"] for row in mine):.2f} | {max(row["t_ulp_p99"] for row in mine):.2f} '
               f'| {max(row["t_ulp_max"] for row in mine):.2f} | {max(row["normal_rad_max"] for row in mine):.1e} '
               f'| {torture["fallback_pct"]:.1f} % | {far["ns_ray_med"]:.0f} | {near["ns_ray_med"]:.0f} |')


def sweep_table(rows):
    yield '| | ' + ' | '.join(name for _, _, name in COLUMNS) + ' |'
    yield '|' + '---|' * (len(COLUMNS) + 1)
    for kind in KINDS:
        cells = [chosen(rows, kind=kind, method='certified', family=family, param=param)[0]['t_ulp_max']
                 for family, param, _ in COLUMNS]
        yield f'| {kind} | ' + ' | '.join(short(cell) for cell in cells) + ' |'


def method_table(rows):
    yield ('| | method | ns at distance 1000 | max ulp there | at 1e6 | at 1e12 | misjudged, all families | normal, rad '
           '| self-hits, leaks, of all |')
    yield '|' + '---|' * 9
    for kind in KINDS:
        for method in METHODS:
            all_of = chosen(rows, kind=kind, method=method)
            if not all_of:
                continue
            rays = sum(row['n'] for row in all_of)
            at = {param: chosen(all_of, family='distance', param=param)[0] for param in (1e3, 1e6, 1e12)}
            yield (f'| {kind} | {method} | {at[1e3]["ns_ray_med"]:.0f} '
                   + ''.join(f'| {short(at[param]["t_ulp_max"])} ' for param in (1e3, 1e6, 1e12))
                   + f'| {share(misjudged(all_of), rays)} | {max(row["normal_rad_max"] for row in all_of):.1e} '
                   f'| {share(sum(row["selfhit"] + row["leak"] for row in all_of), rays)} |')


def tables(rows):
    torture = chosen(rows, method='certified', family='torture')
    yield (f'{torture[0]["n"]:.0f} rays of torture for a kind, a tenth of that for each other family; our own kernels, worst '
           'over all families of a kind:')
    yield ''
    yield from product_table(rows)
    yield ''
    yield 'Greatest error of a distance, in units in the last place, by distance over size and by other trouble:'
    yield ''
    yield from sweep_table(rows)
    yield ''
    yield 'All methods on the same rays, timed in turn:'
    yield ''
    yield from method_table(rows)


def refresh(path, lines):
    text = path.read_text(encoding='utf-8')
    begin, end = (text.index(mark) for mark in MARKS)
    path.write_text(text[:begin + len(MARKS[0])] + '\n'.join(lines) + '\n' + text[end:], encoding='utf-8')


def worst_of_promise(rows):
    """Over what is promised, and what all methods can be asked: distance, translation, scale, grazing."""
    return [row for row in rows if row['family'] in ('distance', 'translation', 'scale', 'grazing')]


def points(rows):
    """What the plot program reads: plot, panel, method, x, y, promise, whether none was misjudged."""
    for kind in KINDS:
        for method in METHODS:
            mine = chosen(rows, kind=kind, method=method)
            promised = worst_of_promise(mine)
            if not promised:
                continue
            time = chosen(mine, family='distance', param=1e3)[0]['ns_ray_med']
            yield 'work', kind, method, time, max(row['t_ulp_max'] for row in promised), LIMITS[kind], misjudged(promised) == 0
            for row in chosen(mine, family='distance'):
                yield 'distance', kind, method, row['param'], row['t_ulp_max'], LIMITS[kind], misjudged([row]) == 0


def main():
    if len(sys.argv) != 5:
        sys.exit(__doc__.splitlines()[2].strip())
    rows = read(sys.argv[1])
    refresh(pathlib.Path(sys.argv[2]), tables(rows))
    lines = ''.join(' '.join(map(str, point[:-1])) + f' {int(point[-1])}\n' for point in points(rows))
    subprocess.run([sys.argv[4], sys.argv[3]], input=lines, text=True, check=True)


if __name__ == '__main__':
    main()
