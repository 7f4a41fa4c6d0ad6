"""Render a picture on a Dask cluster: python -m povtrace.cluster SCENE WIDTH HEIGHT OUTPUT [options] [povc's options]

The picture is cut into parts that `povc --part` traces on the workers and `povc --merge` joins here, to the bits of one
run on one machine. The scene and the files that it reads are sent once to each worker, also to those that join later. If
a worker dies, Dask gives its parts to others. Parts that are done lie beside OUTPUT: a run that was interrupted goes on
with those that are missing.

With --frames A-B each frame of an animation is a task, and OUTPUT a picture for each: out.png is out01.png, out02.png, ...

Needs distributed (PyPI) here and on the workers, and povc on all of them.
"""
from __future__ import annotations

import argparse
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import uuid
import zipfile
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

PARTS_PER_THREAD = 4
RETRIES = 2
ANOTHER_ROUND = 4                # povc --merge: the next samples depend on the whole picture
QUOTED = re.compile(rb'"([^"\n]+)"')


class RenderError(Exception):
    """What povc said when it failed."""


# ---- the scene, with the files that it reads ----

def files_of(scene: Path, folders: Iterable[Path]) -> Iterator[Path]:
    """The scene, and what its text and that of the files it includes name in quotation marks, if that is a file."""
    places = [scene.parent, *folders]
    pending, seen = [scene], {scene}
    while pending:
        file = pending.pop()
        yield file
        if file.suffix.lower() not in ('.pov', '.inc', '.mcr'):
            continue
        for word in QUOTED.findall(file.read_bytes()):
            for found in (place / os.fsdecode(word) for place in (file.parent, *places)):
                if found.is_file() and found.resolve() not in seen:
                    seen.add(found.resolve())
                    pending.append(found.resolve())


def pack(files: Iterable[Path]) -> tuple[bytes, Path]:
    """An archive of the files, and the folder that it begins at."""
    files = sorted({file.resolve() for file in files})
    top = Path(os.path.commonpath([file.parent for file in files]))
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, 'w', zipfile.ZIP_DEFLATED) as archive:
        for file in files:
            archive.write(file, file.relative_to(top))
    return packed.getvalue(), top


# ---- on a worker ----

class SceneFiles:
    """A worker's plugin of Dask: unpacks the scene into a folder of the worker's, when that starts or joins."""

    def __init__(self, archive: bytes):
        self.archive = archive
        self.name = f'povtrace-{uuid.uuid4()}'

    def setup(self, worker: Any) -> None:
        folder = Path(tempfile.mkdtemp(prefix='povtrace-', dir=getattr(worker, 'local_directory', None)))
        with zipfile.ZipFile(io.BytesIO(self.archive)) as archive:
            archive.extractall(folder)
        worker.povtrace_folders = {**getattr(worker, 'povtrace_folders', {}), self.name: folder}

    def teardown(self, worker: Any) -> None:
        folder = getattr(worker, 'povtrace_folders', {}).pop(self.name, None)
        if folder:
            shutil.rmtree(folder, ignore_errors=True)


def die_with_parent() -> None:
    """A part whose worker was killed is traced by another: this process would be in its way. On Linux."""
    if sys.platform == 'linux':
        import ctypes
        ctypes.CDLL(None).prctl(1, 9)    # PR_SET_PDEATHSIG, SIGKILL


def run_povc(name: str, povc: str, words: list[str], written: str, given: dict[str, bytes]) -> bytes:
    """Run povc in the folder of the scene; `given` are files that it needs there. The file that it writes."""
    from distributed import get_worker
    folder = get_worker().povtrace_folders[name]
    for file, content in given.items():
        write_whole(folder / file, content)
    done = subprocess.run([povc, *words], cwd=folder, capture_output=True, text=True, preexec_fn=die_with_parent, check=False)
    if done.returncode not in (0, 3):
        raise RenderError(f'{get_worker().address}: povc ended with {done.returncode}: {done.stderr.strip()[-2000:]}')
    return (folder / written).read_bytes()


# ---- here ----

def write_whole(path: Path, content: bytes) -> None:
    """The file is there with all of it, or as it was."""
    beside = path.with_name(f'{path.name}.{os.getpid()}-{threading.get_ident()}.tmp')
    beside.write_bytes(content)
    beside.replace(path)


class Progress:
    """How far it is, on standard error: a line that is rewritten on a terminal, else one each ten seconds."""

    def __init__(self, what: str, count: int, quiet: bool):
        self.what, self.count, self.quiet = what, count, quiet
        self.done, self.start, self.shown = 0, time.monotonic(), 0.0

    def step(self) -> None:
        self.done += 1
        now = time.monotonic() - self.start
        if self.quiet or (not sys.stderr.isatty() and now - self.shown < 10 and self.done < self.count):
            return
        self.shown = now
        left = now / self.done * (self.count - self.done)
        text = f'povtrace: {self.done} of {self.count} {self.what}, {now:.0f} s, about {left:.0f} s to go'
        print(f'\r{text}\033[K' if sys.stderr.isatty() else text, end='' if sys.stderr.isatty() else '\n', file=sys.stderr, flush=True)

    def end(self) -> None:
        if not self.quiet and sys.stderr.isatty():
            print(file=sys.stderr)


def threads_of(client: Any) -> int:
    return max(1, sum(client.nthreads().values()))


class Render:
    """A scene on a cluster. `words` are povc's further options."""

    def __init__(self, client: Any, scene: Path, size: tuple[int, int], words: list[str], files: Iterable[Path] = (),
                 folders: Iterable[Path] = (), povc: str = 'povc', quiet: bool = False):
        scene = scene.resolve()
        folders = [folder.resolve() for folder in folders]
        archive, top = pack([*files_of(scene, folders), *files])
        povc = os.path.abspath(povc) if os.sep in povc else povc     # workers run it in folders of their own
        self.client, self.size, self.povc, self.quiet = client, size, povc, quiet
        self.scene = str(scene.relative_to(top))
        self.words = words + [word for folder in folders if folder.is_relative_to(top) for word in ('-L', str(folder.relative_to(top)))]
        self.pictures = 0
        plugin = SceneFiles(archive)
        self.name = plugin.name
        register = getattr(client, 'register_plugin', None) or client.register_worker_plugin
        register(as_plugin(plugin), name=plugin.name)

    def __enter__(self) -> Render:
        return self

    def __exit__(self, *_: Any) -> None:
        """The workers forget the scene."""
        self.client.unregister_worker_plugin(self.name)

    def _run(self, tasks: dict[Any, tuple[list[str], str]], what: str, given: Any, take: Callable[[Any, bytes, str], None],
             near: dict[Any, str]) -> None:
        """Run povc for each task: its words, and the file that it writes; take(key, content, worker) what that is."""
        from distributed import as_completed
        progress = Progress(what, len(tasks), self.quiet)
        keys = {}
        for key, (words, written) in tasks.items():
            future = self.client.submit(run_povc, self.name, self.povc, words, written, given, retries=RETRIES, pure=False,
                                        workers=near.get(key), allow_other_workers=key in near)
            keys[future] = key
        try:
            for future in as_completed(list(keys)):
                where = list(self.client.who_has([future]).get(future.key, ()))
                take(keys.pop(future), future.result(), where[0] if where else '')
                progress.step()
        finally:
            for future in keys:
                future.cancel()
            progress.end()

    def picture(self, output: Path, parts: int = 0) -> int:
        """Render one picture; the exit status of povc --merge."""
        parts = parts or PARTS_PER_THREAD * threads_of(self.client)
        near: dict[int, str] = {}
        self.pictures += 1
        while True:
            self._parts(output, parts, near)
            status = subprocess.run([self.povc, '--merge', str(output), *(['-q'] if self.quiet else [])], check=False).returncode
            if status != ANOTHER_ROUND:
                return status

    def _parts(self, output: Path, parts: int, near: dict[int, str]) -> None:
        """Trace the parts of a round. In later rounds a part goes on best where it was."""
        width, height = self.size
        there = f'{self.pictures}-{output.name}'     # another picture of this name may have left files on the workers
        round_file = output.with_name(output.name + '.round')
        given = {there + '.round': round_file.read_bytes()} if round_file.exists() else {}
        names = {part: f'.part-{part}-of-{parts}' for part in range(1, parts + 1)}
        tasks = {part: ([self.scene, str(width), str(height), there, '-q', '-t', '1', '--part', f'{part}/{parts}', *self.words], there + name)
                 for part, name in names.items() if given or not output.with_name(output.name + name).exists()}

        def take(part: int, content: bytes, worker: str) -> None:
            write_whole(output.with_name(output.name + names[part]), content)
            near[part] = worker

        # In a list it gets a key of its own: a dict's keys would be those of the round before, which may still be there.
        shared = self.client.scatter([given], broadcast=True, hash=False)[0] if given else {}
        self._run(tasks, 'parts', shared, take, {part: worker for part, worker in near.items() if worker in self.client.nthreads()})

    def frames(self, output: Path, first: int, last: int, clocks: tuple[float, float] = (0.0, 1.0),
               wanted: Iterable[int] | None = None) -> None:
        """Render the frames of an animation; a frame is a task."""
        width, height = self.size
        digits = len(str(last))
        frames = list(wanted if wanted is not None else range(first, last + 1))
        names = {frame: f'{output.stem}{frame:0{digits}}{output.suffix}' for frame in frames}

        def words(frame: int) -> list[str]:
            step = (clocks[1] - clocks[0]) / max(1, last - first)
            values = {'clock': clocks[0] + (frame - first) * step, 'frame_number': frame, 'initial_frame': first, 'final_frame': last,
                      'initial_clock': clocks[0], 'final_clock': clocks[1], 'clock_delta': step, 'clock_on': 1}
            declared = [word for name, value in values.items() for word in ('-D', f'{name}={value!r}')]
            return [self.scene, str(width), str(height), names[frame], '-q', '-t', '1', *declared, *self.words]

        self._run({frame: (words(frame), names[frame]) for frame in frames}, 'frames', {},
                  lambda frame, content, _: write_whole(output.with_name(names[frame]), content), {})


def as_plugin(files: SceneFiles) -> Any:
    """The same as a plugin of the class that newer versions of Dask want."""
    from distributed import WorkerPlugin

    class Plugin(WorkerPlugin):
        name = files.name

        def setup(self, worker: Any) -> None:
            files.setup(worker)

        def teardown(self, worker: Any) -> None:
            files.teardown(worker)

    return Plugin()


# ---- the command ----

def span(text: str) -> tuple[int, int]:
    first, _, last = text.replace('..', '-').partition('-')
    return int(first), int(last or first)


def clock_span(text: str) -> tuple[float, float]:
    first, _, last = text.partition(',')
    return float(first), float(last)


def arguments() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog='python -m povtrace.cluster', description=__doc__.split('\n', 1)[0],
                                     epilog="All other options are povc's, such as --error 0.002.")
    parser.add_argument('scene', type=Path)
    parser.add_argument('width', type=int)
    parser.add_argument('height', type=int)
    parser.add_argument('output', type=Path)
    parser.add_argument('--scheduler', metavar='ADDRESS', help='such as tcp://host:8786; without it, processes of this machine')
    parser.add_argument('--workers', type=int, help='processes of this machine, without --scheduler')
    parser.add_argument('--parts', type=int, default=0, help=f'parts of the picture (default: {PARTS_PER_THREAD} a thread)')
    parser.add_argument('--frames', type=span, metavar='A-B', help='an animation: a picture for each frame')
    parser.add_argument('--clock', type=clock_span, metavar='A,B', default=(0.0, 1.0), help='of the first and the last frame (default 0,1)')
    parser.add_argument('--file', type=Path, action='append', default=[], help='a file that the scene reads and names by a computed string')
    parser.add_argument('-L', '--library-path', type=Path, action='append', default=[], help='folder of included files, here')
    parser.add_argument('--povc', default='povc', help='the program, here and on the workers')
    parser.add_argument('-q', '--quiet', action='store_true')
    return parser


def connect(a: argparse.Namespace) -> Any:
    from distributed import Client, LocalCluster
    if a.scheduler:
        return Client(a.scheduler)
    return Client(LocalCluster(n_workers=a.workers or os.cpu_count() or 1, threads_per_worker=1, dashboard_address=':0'))


def render_with(client: Any, a: argparse.Namespace, words: list[str]) -> int:
    with Render(client, a.scene, (a.width, a.height), words, a.file, a.library_path, a.povc, a.quiet) as render:
        if not a.frames:
            return render.picture(a.output, a.parts)
        render.frames(a.output, *a.frames, clocks=a.clock)
        return 0


def main() -> int:
    a, words = arguments().parse_known_args()
    try:
        with connect(a) as client:
            return render_with(client, a, words)
    except (RenderError, OSError) as error:
        print(f'povtrace: {error}', file=sys.stderr)
        return 1


if __name__ == '__main__':
    sys.exit(main())
