#!/usr/bin/env python3
"""Run the examples of the documentation as they are printed: examples.py [PAGE ...].

Every fenced block of a page is one of these, by its language and by the comment `<!-- example: ... -->` above it:

    sh                       run in the page's folder; it must succeed
    pov                      saved as scene.pov and checked by povc: no error, no warning, no feature that is not drawn
    c, pov: file NAME        saved as NAME; C is compiled with all warnings. A second block of that name continues the file
                             behind an empty line
    c: file NAME, is PATH    the same, and the whole is the tree's file PATH
    c: within NAME           a fragment: tests/docs/within/NAME includes it as "block.c", is compiled and run
    text: prints             what the sh block before printed, on both streams
    text: prints: COMMAND    what the command prints
    any: not run: WHY        skipped, and counted

`; seconds vary` or `; numbers vary` behind `prints` says what is not compared. `needs NAME` before anything else skips the
block where there is neither a program nor a package of that name. A comment `<!-- example: hidden file NAME`, its text on
the following lines, saves a file that the page does not show. Each page has a folder of its own that begins with
tests/docs/files and the tree's scenes. Ends with "N passed, N failed, N skipped".
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get('BUILD_DIR', ROOT / 'build'))
CC = os.environ.get('CC', 'cc')
STRICT = ['-std=c99', '-Wall', '-Wextra', '-Wpedantic', '-Wshadow', '-Werror', '-ffp-contract=off']
LIMIT_S = 600
DONE = ('run', 'checked', 'compared', 'compiled', 'compiled and run', 'saved')
PART = re.compile(r'^<!-- example: (?P<comment>.*?) ?-->\n|^```(?P<language>\w*)\n(?P<text>.*?)^```$', re.M | re.S)


class Failure(Exception):
    pass


class Skipped(Exception):
    pass


def pages():
    return [ROOT / 'README.md', *sorted((ROOT / 'docs').glob('*.md')), ROOT / 'scenes/README.md']


def stage(folder):
    """Lay out the build as an installation, so that pkg-config finds it."""
    (folder / 'lib/pkgconfig').mkdir(parents=True)
    (folder / 'include').symlink_to(ROOT / 'lib/include')
    for file in (BUILD / 'lib').iterdir():
        (folder / 'lib' / file.name).symlink_to(file.resolve())
    values = {'PREFIX': folder, 'LIBDIR': folder / 'lib', 'INCLUDEDIR': folder / 'include', 'VERSION': '0'}
    text = (ROOT / 'lib/povtrace.pc.in').read_text()
    (folder / 'lib/pkgconfig/povtrace.pc').write_text(re.sub(r'@(\w+)@', lambda m: str(values[m[1]]), text))


def environment(staged):
    found = dict(os.environ, LC_ALL='C', PATH=f'{BUILD / "bin"}:{os.environ["PATH"]}',
                 PKG_CONFIG_PATH=f'{staged / "lib/pkgconfig"}:{os.environ.get("PKG_CONFIG_PATH", "")}',
                 LD_LIBRARY_PATH=str(staged / 'lib'))
    for name in ('POVTRACE_PLUGIN_PATH', 'DISPLAY'):
        found.pop(name, None)
    return found


def is_here(name, env):
    return shutil.which(name, path=env['PATH']) or not subprocess.run(['pkg-config', '--exists', name], env=env).returncode


def blurred(text, option):
    """The text without what the page says may vary."""
    pattern = {'': None, 'seconds vary': r'\d+(\.\d+)? s\b', 'numbers vary': r'\d+(\.\d+)?'}[option]
    return re.sub(pattern, '#', text) if pattern else text


class Page:
    def __init__(self, folder, env):
        self.folder, self.env, self.printed = folder, env, None
        shutil.copytree(ROOT / 'tests/docs/files', folder)
        (folder / 'scenes').symlink_to(ROOT / 'scenes')

    def call(self, command, shell=False):
        done = subprocess.run(['sh', '-ec', command] if shell else command, cwd=self.folder, env=self.env, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LIMIT_S)
        self.printed = done.stdout
        return done.returncode

    def must(self, command, shell=False):
        if self.call(command, shell):
            raise Failure(self.printed)

    def save(self, name, text):
        file = self.folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text((file.read_text() + '\n' if file.exists() and name.endswith('.c') else '') + text)

    def flags(self):
        return subprocess.check_output(['pkg-config', '--cflags', '--libs', 'povtrace'], env=self.env, text=True).split()

    def run_fragment(self, name, text):
        (self.folder / 'block.c').write_text(text)
        self.must([CC, *STRICT, f'-I{self.folder}', str(ROOT / 'tests/docs/within' / name), *self.flags(), '-o', 'fragment'])
        self.must(['./fragment'])

    def compare(self, comment, text):
        comment, _, option = comment.partition('; ')
        command = comment.partition(': ')[2]
        if command:
            self.call(command, shell=True)
        if blurred(self.printed or '', option) != blurred(text, option):
            raise Failure(f'printed is:\n{self.printed}')

    def run(self, language, comment, text):
        """Do what a block asks for, and say what was done."""
        needed = re.match(r'needs ([\w.-]+),? ?(.*)', comment, re.S)
        if needed:
            comment = needed[2]
            if not is_here(needed[1], self.env):
                raise Skipped(f'there is no {needed[1]}')
        if comment.startswith('not run: '):
            raise Skipped(comment[len('not run: '):])
        if comment.startswith('file '):
            return self.save(comment[len('file '):].partition(',')[0], text) or 'saved'
        if comment.startswith('within '):
            return self.run_fragment(comment[len('within '):], text) or 'compiled and run'
        if comment.startswith('prints'):
            return self.compare(comment, text) or 'compared'
        if comment or language not in ('sh', 'pov'):
            raise Failure(f'the page does not say what to do with this block of "{language}": {comment or "no comment"}')
        if language == 'sh':
            return self.must(text, shell=True) or 'run'
        self.save('scene.pov', text)
        self.must(['povc', '--check', '--strict', 'scene.pov'])
        if 'warning:' in self.printed:
            raise Failure(self.printed)
        return 'checked'

    def finish(self, name, original):
        """A whole file: C compiles without a warning, and is the tree's if the page says so."""
        if original and (self.folder / name).read_text() != (ROOT / original).read_text():
            raise Failure(f'it is not {original} line for line')
        if name.endswith('.c'):
            needs = ['glfw3'] if 'GLFW/' in (self.folder / name).read_text() else []
            if needs and not is_here('glfw3', self.env):
                raise Skipped('there is no glfw3')
            flags = subprocess.check_output(['pkg-config', '--cflags', 'povtrace', *needs], env=self.env, text=True)
            self.must([CC, *STRICT, '-fsyntax-only', *flags.split(), name])
        return 'compiled' if name.endswith('.c') else 'saved'


def blocks(text):
    """(line, language, comment, text) of each block; hidden files have the language `hidden`."""
    comment = ''
    for part in PART.finditer(text):
        line = text.count('\n', 0, part.start()) + 1
        if part['comment'] is None:
            yield line, part['language'], comment, part['text']
            comment = ''
        elif part['comment'].startswith('hidden '):
            head, _, body = part['comment'].partition('\n')
            yield line, 'hidden', head[len('hidden '):], body
        else:
            comment = ' '.join(part['comment'].split())


def files_of(found):
    """The names of files that blocks make, with the tree's file that each has to be."""
    names = {}
    for _, _, comment, _ in found:
        whole = re.match(r'(?:needs [\w.-]+,? ?)?file ([\w./-]+)(?:, is (\S+))?$', comment)
        if whole:
            names[whole[1]] = whole[2] or names.get(whole[1])
    return names


class Report:
    def __init__(self):
        self.counts = Counter()

    def attempt(self, name, action):
        try:
            done = action()
            self.counts['passed'] += 1
            self.counts[done] += 1
            print(f'ok {name}: {done}')
        except Skipped as why:
            self.counts['skipped'] += 1
            print(f'ok {name} # skipped: {why}')
        except (Failure, OSError, subprocess.SubprocessError) as error:
            self.counts['failed'] += 1
            print(f'not ok {name}\n    ' + str(error).rstrip().replace('\n', '\n    '))

    def page(self, path, folder, env):
        found = list(blocks(path.read_text()))
        name = path.relative_to(ROOT)
        page = Page(folder, env)
        # Files first: a page may show the command before the program.
        for is_file in (True, False):
            for line, language, comment, text in found:
                if (re.match(r'(needs [\w.-]+,? ?)?file ', comment) is not None) == is_file:
                    self.attempt(f'{name}:{line}', lambda: page.run(language, comment, text))
            for file, original in files_of(found).items() if is_file else ():
                self.attempt(f'{name} {file}', lambda: page.finish(file, original))


def main():
    report = Report()
    with tempfile.TemporaryDirectory(prefix='povtrace-docs.') as work:
        stage(Path(work) / 'stage')
        env = environment(Path(work) / 'stage')
        for number, path in enumerate([Path(name).resolve() for name in sys.argv[1:]] or pages()):
            report.page(path, Path(work) / str(number), env)
    counts = report.counts
    print(', '.join(f'{counts[done]} {done}' for done in DONE))
    print(f'{counts["passed"]} passed, {counts["failed"]} failed, {counts["skipped"]} skipped')
    return counts['failed'] > 0 or not counts['passed']


if __name__ == '__main__':
    sys.exit(main())
