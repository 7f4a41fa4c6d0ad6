#!/usr/bin/env python3
"""Holds what povc says of its error against the truth, on every scene of the gallery.

The truth is a picture of 65 536 samples a pixel of another seed, kept for the next run; or the mean of several of as many
seeds: late samples of a picture with photons share two maps, whose error does not fall with more of them. Held are, unless
options say otherwise: est_over_true within 0.85 .. 1.18 in each row from 4 to 1024 samples; the 95 % band around the true
error in 90 % of the rows; a true error below 0.0024 after --error 0.002; --time 2 ending within 0.1 s. Last, how much more
uniform sampling takes than adaptive to --error 0.002. The exit status is 1 if something is not held.

Estimate and true error of one picture are two numbers of chance. How far the logarithm of their ratio spreads follows from
the band; it falls with the number of pixels that share the error. It is printed, and how many rows such a spread puts
outside: --size is to be so large, or --pictures so many, that these are few. A row of several pictures, one for each seed, has
the rms of their estimates over the rms of their true errors. A truth that is not much better than a row adds its own error."""
import argparse
import array
import csv
import hashlib
import math
import os
import statistics
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SECONDS, LATE = 2.0, 0.1
GAIN = 2.0
SEED = 777
WAYS = ('uniform', 'adaptive')


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--work', default='build/validate', help='where references are kept')
    parser.add_argument('--size', default='64x48', help='of the pictures with a reference')
    parser.add_argument('--truth', type=int, default=65536, help='samples a pixel of a reference')
    parser.add_argument('--truth-sampling', default='uniform', help='of a reference; adaptive where few pixels have the error')
    parser.add_argument('--seeds', type=int, default=1, help='pictures whose mean is a reference')
    parser.add_argument('--pictures', type=int, default=1, help='seeds, from 0 on, whose pictures make a row together')
    parser.add_argument('--most', type=int, default=1024, help='samples a pixel of the rows')
    parser.add_argument('--large', default='320x240', help='of the pictures whose cost is compared')
    parser.add_argument('--ratio', default='0.85,1.18', help='least and largest estimate over truth in a row')
    parser.add_argument('--covered', type=float, default=0.9, help='share of the rows whose band holds')
    parser.add_argument('--error', default='0.002,0.0024', help='what is asked for, and below what the truth has to end')
    parser.add_argument('--parts', default='rows,error,time,gain', help='what to do')
    parser.add_argument('scenes', nargs='*', help='default: the gallery')
    options = parser.parse_args()
    options.parts = options.parts.split(',')
    options.lowest, options.highest = map(float, options.ratio.split(','))
    options.asked, options.reached = map(float, options.error.split(','))
    options.scenes = [Path(name) for name in options.scenes] or sorted((ROOT / 'scenes/gallery').glob('*.pov'))
    return options


def render(options, scene, size, output, *more):
    """The exit status is 3 when a limit came before what was asked for: that is no failure here."""
    command = [options.povc, str(scene), *size.split('x'), str(output), '-q', *more]
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 3):
        sys.exit(f'validate: {" ".join(command)}: {done.stderr}')


def rows_of(options, scene, size, *more):
    """The report's rows, as numbers; what is not known is None."""
    work = Path(options.work)
    report = work / f'{os.getpid()}.csv'
    render(options, scene, size, work / f'{os.getpid()}.pfm', '--report', str(report), *more)
    with open(report, newline='', encoding='ascii') as file:
        return [{key: float(text) if text else None for key, text in row.items()} for row in csv.DictReader(file)]


def one_truth(options, scene, path, seed):
    if not path.exists():
        part = path.with_suffix('.part.pfm')
        resume = ['--resume'] if Path(f'{part}.checkpoint').exists() else []
        render(options, scene, options.size, part, '--spp', str(options.truth), '--sampling', options.truth_sampling,
               '--seed', str(seed), '--partial-every', '60', *resume)
        part.rename(path)
    return path


def write_mean(pictures, path):
    """Of PFM files of one size, in the byte order of this machine."""
    sums = head = None
    for picture in pictures:
        with open(picture, 'rb') as file:
            head = b''.join(file.readline() for _ in range(3))
            values = array.array('f', file.read())
        sums = array.array('d', values) if sums is None else array.array('d', map(float.__add__, sums, values))
    path.write_bytes(head + array.array('f', (value / len(pictures) for value in sums)).tobytes())


def truth_of(options, scene):
    """A reference is made once; when it was interrupted, the next run goes on with it."""
    name = hashlib.sha256(scene.read_bytes()).hexdigest()[:12]
    how = f'{options.truth}{f"x{options.seeds}" if options.seeds > 1 else ""}{"a" if options.truth_sampling == "adaptive" else ""}'
    path = Path(options.work) / f'{scene.stem}-{options.size}-{how}-{name}.pfm'
    if not path.exists():
        some = [one_truth(options, scene, path.with_suffix(f'.{SEED + k}.pfm'), SEED + k) for k in range(options.seeds)]
        write_mean(some, path)
        for one in some:
            one.unlink()
    return path


def rays(row):
    return row['primary_rays'] + row['secondary_rays'] + row['shadow_rays']


def spread(row):
    """Of the logarithm of estimate over true error, by the band: it is 1.96 of these wide on each side."""
    return math.log(row['est_ci95_hi'] / row['est_rmse']) / 1.96


def root_mean_square(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def held_by(row):
    return row['est_ci95_lo'] <= row['ref_rmse'] <= row['est_ci95_hi']


def joint_rows(options, scene, truth, way):
    """For each row of the report: samples, rms estimate over rms true error, and its spread, over some pictures; and whether
    each picture's band holds. What an adaptive picture has in a row of its own at its end is left out."""
    several = [rows_of(options, scene, options.size, '--spp', str(options.most), '--sampling', way, '--reference', str(truth),
                       '--seed', str(seed)) for seed in range(options.pictures)]
    for rows in zip(*several):
        if rows[0]['spp_mean'] >= 4 and all(row['est_rmse'] for row in rows):
            told, true = (root_mean_square([row[key] for row in rows]) for key in ('est_rmse', 'ref_rmse'))
            squares = [row['est_rmse'] ** 2 for row in rows]
            deviation = math.hypot(*(spread(row) * square for row, square in zip(rows, squares))) / sum(squares)
            yield rows[0]['spp_mean'], told / true, deviation, [held_by(row) for row in rows]


def chance_outside(options, deviation):
    normal = statistics.NormalDist(0.0, deviation)
    return 1.0 - normal.cdf(math.log(options.highest)) + normal.cdf(math.log(options.lowest))


def hold_rows(options, scene, truth):
    """Over both ways of sampling: rows, bands, bands that held, rows that chance puts outside the limits, and those outside."""
    count = bands = held = 0
    chance = 0.0
    outside = []
    for way in WAYS:
        samples, ratios, spreads, holds = zip(*joint_rows(options, scene, truth, way))
        holds = sum(holds, [])
        outside += [f'{way} at {n:.0f}: {ratio:.2f}' for n, ratio in zip(samples, ratios)
                    if not options.lowest <= ratio <= options.highest]
        count, bands, held = count + len(ratios), bands + len(holds), held + sum(holds)
        chance += sum(chance_outside(options, deviation) for deviation in spreads)
        print(f'{scene.stem:14} {way:9} estimated / true {min(ratios):.2f} ... {max(ratios):.2f}'
              f'   spread by the bands {statistics.median(spreads):.2f}   band holds {sum(holds)} of {len(holds)}', flush=True)
    return count, bands, held, chance, outside


def check_rows(options):
    count = bands = held = 0
    chance = 0.0
    outside = []
    for scene in options.scenes:
        rows, covering, covered, by_chance, wrong = hold_rows(options, scene, truth_of(options, scene))
        count, bands, held, chance = count + rows, bands + covering, held + covered, chance + by_chance
        outside += [f'{scene.stem} {text}' for text in wrong]
    print(f'rows: {len(outside)} of {count} outside {options.lowest} ... {options.highest} ({chance:.1f} by chance); '
          f'bands hold {held} of {bands}, {100.0 * held / bands:.1f} % ({100 * options.covered:.0f} % asked)')
    for text in outside:
        print(f'  {text}')
    return not outside and held >= options.covered * bands


def check_error(options):
    worst = 0.0
    for scene in options.scenes:
        ends = [rows_of(options, scene, options.size, '--error', str(options.asked), '--reference', str(truth_of(options, scene)),
                        '--seed', str(seed))[-1] for seed in range(options.pictures)]
        largest = max(end['ref_rmse'] for end in ends)
        print(f'{scene.stem:14} --error {options.asked}: {statistics.mean(end["spp_mean"] for end in ends):.1f} samples, '
              f'estimated {root_mean_square([end["est_rmse"] for end in ends]):.5f}, '
              f'true {root_mean_square([end["ref_rmse"] for end in ends]):.5f}, at most {largest:.5f}', flush=True)
        worst = max(worst, largest)
    print(f'error: largest true error {worst:.5f} ({options.reached} allowed)')
    return worst < options.reached


def check_time(options):
    worst = 0.0
    for scene in options.scenes:
        last = rows_of(options, scene, options.large, '--time', str(SECONDS))[-1]
        print(f'{scene.stem:14} --time {SECONDS}: ended after {last["wall_s"]:.3f} s', flush=True)
        worst = max(worst, abs(last['wall_s'] - SECONDS))
    print(f'time: {worst:.3f} s off at most ({LATE} allowed)')
    return worst < LATE


def check_gain(options):
    """What uniform sampling takes over what adaptive sampling takes: the first that is not above the error asked for."""
    times = []
    for scene in options.scenes:
        both = [rows_of(options, scene, options.large, '-t', '1', '--error', str(options.asked), '--sampling', way)[-1] for way in WAYS]
        uniform, adaptive = both
        times.append(uniform['cpu_s'] / adaptive['cpu_s'])
        print(f'{scene.stem:14} samples {uniform["spp_mean"]:.1f} / {adaptive["spp_mean"]:.1f}'
              f'   rays {rays(uniform) / rays(adaptive):.2f}   processor time {times[-1]:.2f}'
              f'   estimated {uniform["est_rmse"]:.5f} / {adaptive["est_rmse"]:.5f}', flush=True)
    print(f'gain: {statistics.median(times):.2f} times in processor time on the median scene ({GAIN} asked)')
    return statistics.median(times) >= GAIN


def main():
    options = arguments()
    Path(options.work).mkdir(parents=True, exist_ok=True)
    checks = {'rows': check_rows, 'error': check_error, 'time': check_time, 'gain': check_gain}
    held = [checks[part](options) for part in options.parts]
    for suffix in ('csv', 'pfm'):
        Path(options.work, f'{os.getpid()}.{suffix}').unlink(missing_ok=True)
    sys.exit(0 if all(held) else 1)


if __name__ == '__main__':
    main()
