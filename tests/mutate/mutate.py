#!/usr/bin/env python3
"""Proves that tests fail: each mutation below makes one mistake in a copy of the tree, which some test must notice.

    python3 tests/mutate/mutate.py [--build build] [--only WORD]

Each is a piece of text that stands exactly once in lib/ and plugins/, and what takes its place; one that is not found is
an error, so that the list is kept up to date. The copy is built at -O1, for the baseline processor, and tested until a
test fails. The table says which. Exit status 1: a mutation survived, or could not be made."""
import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# What goes wrong, the text, what takes its place, and, where the quickest tests would not notice, who should first.
MUTATIONS = [
    ('slab test: slack / 2^8', 'BVH_SLACK 0x1p-22', 'BVH_SLACK 0x1p-30', ''),
    ('side of a leaving ray: limit / 2^8', 'WORLD_GRAZING 0x1p-36', 'WORLD_GRAZING 0x1p-44', ''),
    ('end of a light path: slack / 2^8', 'slack = 0x1p-51', 'slack = 0x1p-59', ''),
    ('limit of the nearest: tie / 2^8', 'PACKET_TIE 0x1p-44', 'PACKET_TIE 0x1p-52', ''),
    ('highlight: exponent one too large', 'double product = 1.0, square = cosine;',
     'double product = cosine, square = cosine;', ''),
    ('highlight: a power of eight for one of four', '(of4, power & 4)', '(of8, power & 4)', ''),
    ('colours: red and blue change places', 'return colour_of(a.r * s, a.g * s, a.b * s);',
     'return colour_of(a.b * s, a.g * s, a.r * s);', ''),
    ('filtered light: green not multiplied', 'g *= (double)filter.g;', '', ''),
    ('patterned shadows: crossings not located', 'w->located = is_located(w, f);', 'w->located = false && is_located(w, f);',
     'golden/test_golden'),
    ('opacity: weighs the wrong way', 'return 1.0f - appearance_covered(m, of->color, of->filter) - of->transmit;',
     'return appearance_covered(m, of->color, of->filter) + of->transmit;', ''),
    ('nested dielectrics: left to the outermost', 'ior_of(m, list[index - 1], hue, white)', 'ior_of(m, list[0], hue, white)', ''),
    ('refraction: relative index upside down', 'steep = 0.5, eta = before / after;',
     'steep = 0.5, eta = after / before;', ''),
    ('depth: one level more than allowed', 'if (p->level >= level) {', 'if (p->level > level) {',
     'unit/test_shade_paths'),
    ('coincident surfaces: the later wins', 'at > 0 && model_is_before(m, h->object, s->at[at - 1].object)',
     'at > 0 && model_is_before(m, s->at[at - 1].object, h->object)',
     'limits/test_coincident'),
    ('isolated solids: no margin', 'static const double margin = 0x1p-20;\n', 'static const double margin = 0.0;\n', 'unit/test_world_isolated'),
    ('filter of instances: bound / 48', '(48.0f *', '(1.0f *', 'unit/test_world_instance'),
    ('sphere: a miss is certain without its bound', 'if (h.d < -(h.d_error + 10.0 * COMMON_U * fabs(h.d)))',
     'if (h.d < 0.0)', 'plugins/test_contract'),
    ('start: a crossing there counts where it grazes', 'cosine = pov_max(fabs(pov_dot(h->normal, pov_unit(ray->dir))), certified',
     'cosine = pov_max(1.0, certified', 'limits/test_starts'),
    ('segments: a surface at the end counts where it is grazed', 'gap * pov_max(own_space_cosine(&own, at), least_cosine) <= reach',
     'gap <= reach', 'limits/test_segments'),
    ('segments: the end is rounded', 'ray.dir_lo = pov_vec3_of(x.lo, y.lo, z.lo);', '', 'limits/test_segments'),
    ('torus: no last step at the start', 'if (is_near || hits->always_exact)', 'if (false)', 'limits/test_starts'),
    ('reports: distances 100 times less exact', '#define COMMON_ULPS 12.0', '#define COMMON_ULPS 1200.0',
     'plugins/test_contract'),
    ('reports: the step of Newton goes the other way', 'return -0.5 * r->value / r->half_slope;',
     'return 0.5 * r->value / r->half_slope;', 'plugins/test_contract'),
]

# In this order, but for who should notice first. The contract takes longest.
TESTS = ['unit/test_query_guards', 'golden/test_golden', 'unit/test_shade_*', 'unit/test_query*', 'unit/test_world_*',
         'limits/test_*', 'plugins/test_contract']
LIMIT = 900   # of a busy machine


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--build', default='build', help='the copy goes into its folder "mutate"')
    parser.add_argument('--only', default='', help='mutations whose name has this word in it')
    parser.add_argument('--places', action='store_true', help='only see whether the text of each is where it has to be')
    parser.add_argument('--jobs', default=str(os.cpu_count() or 1), help='of make')
    return parser.parse_args()


class Broken(Exception):
    """The copy cannot be built, or its tests fail before anything is changed."""


class Copy:
    """The tree once more, to be changed, built and tested."""

    def __init__(self, folder, jobs):
        self.tree, self.jobs = folder, jobs

        def skip(path, names):   # lib/build is a room
            return [name for name in names if name == '.git' or (Path(path) == ROOT and name.startswith('build'))]

        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(ROOT, folder, ignore=skip, symlinks=True)
        self.tests = [str(path.relative_to(folder / 'tests').with_suffix('')) for pattern in TESTS
                      for path in sorted((folder / 'tests').glob(pattern + '.c'))]
        self.tests = list(dict.fromkeys(self.tests))

    def build(self):
        """None, or what the compiler said."""
        ccache = ['CC=ccache ' + os.environ.get('CC', 'cc')] if shutil.which('ccache') else []
        command = ['make', '-s', '-j' + self.jobs, 'WIDE=', 'OPTIMISE=-O1', 'CFLAGS=', 'BUILD=build', *ccache, 'build/bin/povc',
                   *('build/tests/' + test for test in self.tests)]
        environment = {key: value for key, value in os.environ.items() if key not in ('MAKEFLAGS', 'MAKELEVEL', 'MFLAGS')}
        environment.update(CCACHE_BASEDIR=str(self.tree), CCACHE_NOHASHDIR='1')
        made = subprocess.run(command, cwd=self.tree, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              errors='replace')
        return None if made.returncode == 0 else made.stdout

    def failure(self, first=''):
        """The first test that fails, or None."""
        for test in sorted(self.tests, key=lambda name: name != first):   # the others keep their order
            said = run_test(self.tree / 'build/tests' / test)
            if said is not None:
                named = re.findall(r'^\[  FAILED  \] ([a-z]\w*)$', said, re.M)
                return test + (': ' + named[0] if named else ': ' + said.splitlines()[-1] if said else ': crashed')
        return None


def run_test(program):
    """None if it passes, else what it said."""
    try:
        done = subprocess.run([program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors='replace', timeout=LIMIT)
    except subprocess.TimeoutExpired:
        return f'no end after {LIMIT} s'
    return None if done.returncode == 0 else done.stdout


def sources_of(tree):
    return [path for room in ('lib', 'plugins') for path in sorted((tree / room).rglob('*.[ch]'))]


def place_of(tree, text):
    """The only file that the text stands in, or why there is none."""
    found = [path for path in sources_of(tree) for _ in range(path.read_text(errors='replace').count(text))]
    if len(found) != 1:
        return None, f'{"not found" if not found else f"found {len(found)} times"}: {text}'
    return found[0], ''


def verdict_on(copy, mutation):
    """Killed or not, and by which test or why not."""
    _, text, instead, first = mutation
    path, wrong = place_of(copy.tree, text)
    if not path:
        return 'ERROR', wrong
    if first and first not in copy.tests:
        return 'ERROR', f'no such test: {first}'
    original = path.read_text()
    path.write_text(original.replace(text, instead))
    try:
        said = copy.build()
        killer = None if said else copy.failure(first)
    finally:
        path.write_text(original)
    if said:
        return 'ERROR', 'does not compile: ' + next((line for line in said.splitlines() if 'error' in line), said[-200:])
    return ('killed', killer) if killer else ('SURVIVED', '')


def prepare(copy):
    said = copy.build()
    if said:
        raise Broken('the copy cannot be built:\n' + said[-2000:])
    failed = copy.failure()
    if failed:
        raise Broken('a test fails before anything is changed: ' + failed)


def see_places():
    lost = [f'{name}: {place_of(ROOT, text)[1]}' for name, text, _, _ in MUTATIONS if not place_of(ROOT, text)[0]]
    print('\n'.join(lost), end='\n' if lost else '')
    return 1 if lost else 0


def main():
    options = arguments()
    if options.places:
        return see_places()
    copy = Copy((ROOT / options.build / 'mutate').resolve(), options.jobs)
    chosen = [mutation for mutation in MUTATIONS if options.only in mutation[0]]
    started = time.monotonic()
    try:
        prepare(copy)
    except Broken as error:
        sys.exit(f'mutate: {error}')
    width = max(len(mutation[0]) for mutation in chosen)
    killed = 0
    for mutation in chosen:
        verdict, by = verdict_on(copy, mutation)
        killed += verdict == 'killed'
        print(f'{mutation[0]:<{width}}  {verdict:<8}  {by}'.rstrip(), flush=True)
    print(f'{killed} of {len(chosen)} mutations killed, in {time.monotonic() - started:.0f} s')
    return 0 if killed == len(chosen) else 1


if __name__ == '__main__':
    sys.exit(main())
