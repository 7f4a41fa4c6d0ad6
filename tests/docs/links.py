#!/usr/bin/env python3
"""Check that what the documentation points to exists, and that its tables are whole: links.py [PAGE ...].

* A link to a file or an anchor of the tree.
* A path in backticks or plain text, such as `bvh/collapse.c` or docs/numerics.md: it is looked for beside the page, in the
  tree's root, in lib and in plugins.
* A target of make, such as `make bench`.
* A table has a head.
* The marks between which scripts write their tables: one pair for each table.

Ends with "N passed, N failed".
"""
import importlib.util
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True

ROOT = Path(__file__).resolve().parents[2]
PLACES = (ROOT, ROOT / 'lib', ROOT / 'plugins', ROOT / 'lib/include')
LINK = re.compile(r'\]\(([^)\s]+)\)')
PATH = re.compile(r'(?<![\w/.<-])((?:\w[\w-]*/)+[\w-]+\.(?:c|h|py|sh|md|txt|mk))\b')
TARGET = re.compile(r'`make ([a-z][a-z0-9-]*)')


def pages():
    return [ROOT / 'README.md', *sorted((ROOT / 'docs').rglob('*.md')), ROOT / 'scenes/README.md',
            *sorted((ROOT / 'tests').rglob('README.md'))]


def anchors(page):
    """What GitHub makes of the headings."""
    heads = re.findall(r'^#+ (.*)$', page.read_text(), re.M)
    return {re.sub(r'[^\w -]', '', head.lower()).replace(' ', '-') for head in heads}


def prose(page):
    text = re.sub(r'^```.*?^```$', '', page.read_text(), flags=re.M | re.S)
    return re.sub(r'<!-- example: .*?-->', '', text, flags=re.S)


def dead_link(page, link):
    path, _, anchor = link.partition('#')
    target = (page.parent / path).resolve() if path else page
    return not target.exists() or bool(anchor) and anchor not in anchors(target)


def targets_of_make():
    done = subprocess.run(['make', '-pnq', '-C', str(ROOT), 'help'], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    return set(re.findall(r'^([a-z][a-z0-9-]*):', done.stdout, re.M))


def wrong(page, targets):
    text = prose(page)
    for row in re.findall(r'\n\n(\|[^\n]*)\n(?!\|---)', text):
        yield f'a table begins without a head: {row}'
    for link in LINK.findall(text):
        if not link.startswith(('http:', 'https:')) and dead_link(page, link):
            yield f'the link {link} leads nowhere'
    for path in PATH.findall(text):
        if not any((place / path).exists() for place in (page.parent, *PLACES)):
            yield f'there is no {path}'
    for target in TARGET.findall(text):
        if target not in targets:
            yield f'there is no target {target} for make'


def module(path):
    spec = importlib.util.spec_from_file_location(Path(path).stem, ROOT / path)
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def wrong_marks():
    """Tables that a script would not find, or would find twice."""
    bench = ''.join((ROOT / page).read_text() for page in module('tests/bench/tables.py').PAGES)
    for name in module('tests/bench/tables.py').TABLES:
        if len(re.findall(f'<!-- bench:{name} -->\n.*?<!-- end -->', bench, re.S)) != 1:
            yield f'tests/bench/tables.py has not one place for its table {name}'
    numerics = (ROOT / 'docs/numerics.md').read_text()
    for script in ('tests/numerics/accuracy_report.py', 'tests/numerics/cost.py'):
        if any(numerics.count(mark) != 1 for mark in module(script).MARKS):
            yield f'{script} has not one place for its table in docs/numerics.md'


def report(name, found):
    print(f'{"not ok" if found else "ok"} {name}', *found, sep='\n    ')
    return bool(found)


def main():
    targets = targets_of_make()
    chosen = [Path(name).resolve() for name in sys.argv[1:]] or pages()
    results = [report(page.relative_to(ROOT), list(wrong(page, targets))) for page in chosen]
    results.append(report('tables that scripts write', list(wrong_marks())))
    failed = sum(results)
    print(f'{len(results) - failed} passed, {failed} failed')
    return failed > 0


if __name__ == '__main__':
    sys.exit(main())
