#!/usr/bin/env python3
"""Error against processor time of povc and POV-Ray where light goes further: radiosity, media, photons; and through a lens.

Each scene of tests/bench/light is drawn by both programs at several settings, in turn, one thread, and held against a long
run of each. Printed and written are the least processor time of the rounds, the rms error against the program's own long
run, and that against the other's, over the pixels around which one object is seen (of the lens: over all). One sample a pixel goes through its
centre: where shadows have sharp edges such pictures are held against long runs through the centres. Last, how many times as
long POV-Ray takes to an error of 0.01 (of the lens 0.003), by a straight line between its points in logarithms; inf: none of its pictures came there."""
import argparse
import csv
import math
import os
import subprocess
import sys
from pathlib import Path

import curves
import numpy

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / 'compare'))
import images  # noqa: E402

# Scene: settings of POV-Ray from coarse to fine, and of its long run; samples of povc, or errors asked for, and of its own; and how many
# pictures through the centres make one of povc's, or 0. What a scene asks for is what POV-Ray needs for an error of about 0.01.
SCENES = {
    'cornell': ([{'Count': c, 'Bound': b} for c, b in ((35, 1.8), (100, 1.2), (200, .8), (300, .5), (400, .3))],
                {'Count': 1000, 'Bound': .15}, (1, 2, 4, 8, 16), 64, 0),
    'fog': ([{'Method': 3, 'Samples': 10}] + [{'Method': 2, 'Samples': s} for s in (3, 5, 6, 10, 20, 40)],
            {'Method': 2, 'Samples': 400}, (1, 2, 4, 8, 16, 32), 1024, 64),
    'lens': ([{'Blur': b, 'Least': v} for b, v in ((20, .001), (50, .001), (100, .001), (100, .0003), (200, .0003), (37, 0))],
             {'Blur': 400, 'Least': 0}, (4, 8, 16, 32, .01, .003, .0025, .002), 1024, 0),
    'caustic': ([{'Spacing': s} for s in (.02, .01, .005, .0025)], {'Spacing': .001}, (1, 2, 4, 8, 16), 1024, 0),
}
# POV-Ray's long run has 9 samples a pixel, as sharp edges of light need them.
FINE = ('+A0.0', '+AM1', '+R3', '-J')
AIM = {'lens': 0.003}
BLURRED = ('lens',)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--povc', default='build/bin/povc')
    parser.add_argument('--work', default='build/bench')
    parser.add_argument('--size', default='160x120')
    parser.add_argument('--rounds', type=int, default=3)
    parser.add_argument('scenes', nargs='*', help=f'default: {" ".join(SCENES)}')
    options = parser.parse_args()
    options.scenes = options.scenes or list(SCENES)
    options.work = Path(options.work)
    return options


def run(command):
    """Processor seconds of the process."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        sys.exit(f'{" ".join(map(str, command))}: {message.decode(errors="replace")[-800:]}')
    return usage.ru_utime + usage.ru_stime


def draw_povray(options, scene, setting, output, *more):
    width, height = options.size.split('x')
    words = [f'Declare={name}={value}' for name, value in setting.items()]
    return run(['povray', '-D', '-V', *(more or ('-A',)), '+WT1', '+FN16', 'File_Gamma=1.0', f'+W{width}', f'+H{height}', *words,
                f'+I{HERE}/light/{scene}.pov', f'+O{output}'])


def draw_povc(options, scene, samples, output, *more):
    sampling = ['--spp', samples, '--sampling', 'uniform'] if isinstance(samples, int) else ['--error', samples]
    return run([options.povc, f'{HERE}/light/{scene}.pov', '-s', options.size, '-o', output, *map(str, sampling), '-t', '1', '-q', *more])


def picture(path):
    read = images.read_png if path.suffix == '.png' else images.read_pfm
    return numpy.clip(read(path), 0.0, 1.0)


def inner(objects):
    """Pixels whose neighbours all show the same object."""
    same = numpy.ones(objects.shape[:2], bool)
    for y in (-1, 0, 1):
        for x in (-1, 0, 1):
            same &= (numpy.roll(objects, (y, x), (0, 1)) == objects).all(axis=2)
    same[[0, -1]] = same[:, [0, -1]] = False
    return same


def rms(a, b, of):
    return math.sqrt(((a - b)[of] ** 2).mean())


def kept(path, make):
    """A picture that is made once."""
    if not path.exists():
        part = path.with_name('part-' + path.name)
        make(part)
        part.rename(path)
    return path


def centres(options, scene, count, path):
    """The mean of pictures through the centres of the pixels."""
    some = [kept(path.with_name(f'{path.name}.{seed}.pfm'), lambda part, seed=seed: draw_povc(options, scene, 1, part, '--seed', str(seed)))
            for seed in range(1000, 1000 + count)]
    mean = sum(picture(one) for one in some) / count
    for one in some:
        one.unlink()
    with open(path, 'wb') as file:
        numpy.save(file, mean)


def long_runs(options, scene):
    """Both programs' converged pictures, of whole pixels and of their centres, and the pixels that count."""
    _, fine, _, most, count = SCENES[scene]
    names = [options.work / f'light-{scene}-{options.size}-{word}'
             for word in ('povray.png', 'povc.pfm', 'objects.pfm', 'povray-centre.png', 'povc-centre.npy')]
    theirs = picture(kept(names[0], lambda part: draw_povray(options, scene, fine, part, *(() if scene in BLURRED else FINE))))
    ours = picture(kept(names[1], lambda part: draw_povc(options, scene, most, part, '--seed', '777', '--aov', 'object', names[2])))
    whole = {'POV-Ray': theirs, 'povc': ours}
    if scene in BLURRED:
        return whole, whole, numpy.ones(theirs.shape[:2], bool)
    if not count:
        return whole, whole, inner(images.read_pfm(names[2]))
    theirs = picture(kept(names[3], lambda part: draw_povray(options, scene, fine, part)))
    ours = numpy.load(kept(names[4], lambda part: centres(options, scene, count, part)))
    return whole, {'POV-Ray': theirs, 'povc': ours}, inner(images.read_pfm(names[2]))


def measure(options, scene):
    settings, _, counts, _, _ = SCENES[scene]
    whole, centre, of = long_runs(options, scene)
    print(f'{scene}: of {of.mean():.2f} of the pixels the long runs are {rms(*whole.values(), of):.5f} apart, '
          f'those of the centres {rms(*centre.values(), of):.5f}', flush=True)
    jobs = [('POV-Ray', ' '.join(map(str, s.values())), draw_povray, s, '.png', centre) for s in settings]
    jobs += [('povc', f'{n} a pixel' if isinstance(n, int) else f'--error {n}', draw_povc, n, '.pfm', centre if n == 1 else whole) for n in counts]
    rows = [{'scene': scene, 'program': job[0], 'setting': job[1], 'seconds': math.inf} for job in jobs]
    for _ in range(options.rounds):
        for row, (program, _, draw, setting, ending, truth) in zip(rows, jobs):
            output = options.work / f'light-{os.getpid()}{ending}'
            row['seconds'] = min(row['seconds'], draw(options, scene, setting, output))
            drawn = picture(output)
            row['own'] = rms(drawn, truth[program], of)
            row['other'] = rms(drawn, truth['povc' if program == 'POV-Ray' else 'POV-Ray'], of)
            output.unlink()
    return rows


def time_to(rows, program, column, aim):
    """Seconds to the error that is aimed at: of the first picture below it, or between that and the one before."""
    line = sorted((row['seconds'], row[column]) for row in rows if row['program'] == program)
    for k, (t, f) in enumerate(line):
        if f >= aim:
            continue
        if k == 0:
            return t
        s, e = line[k - 1]
        return s * (t / s) ** (math.log(e / aim) / math.log(e / f))
    return math.inf


def main():
    options = arguments()
    options.work.mkdir(parents=True, exist_ok=True)
    rows, panels = [], []
    for scene in options.scenes:
        some, aim = measure(options, scene), AIM.get(scene, 0.01)
        for row in some:
            print(f'{row["program"]:8} {row["setting"]:12} {row["seconds"]:7.3f} s   rms {row["own"]:.5f} of its own,'
                  f' {row["other"]:.5f} of the other\'s long run', flush=True)
        for column in ('own', 'other'):
            both = [time_to(some, program, column, aim) for program in ('POV-Ray', 'povc')]
            print(f'{scene}: to {aim} of {"each its own" if column == "own" else "the other"}: POV-Ray {both[0]:.3f} s, povc {both[1]:.3f} s,'
                  f' {both[0] / both[1]:.2f} times', flush=True)
        panels.append((scene, [(name, [(row['seconds'], row['own']) for row in some if row['program'] == name])
                               for name in ('POV-Ray', 'povc')]))
        rows += some
    with open(options.work / 'light.csv', 'w', newline='', encoding='ascii') as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    (options.work / 'light.svg').write_text(curves.draw('Error against processor time', 'seconds', panels))


if __name__ == '__main__':
    main()
