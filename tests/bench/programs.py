"""The programs that the bench runs: how each is called, and where it says how long it traced.

One thread, one sample a pixel; a timed run writes no file. What counts is the time of tracing as each program measures
it itself: no start, parsing, building or writing. Where other work took part of the processor in the meantime, that
part is taken off, so that a busy machine disturbs little.
"""
import os
import re
import shutil
import subprocess
import time
from dataclasses import dataclass


class ProgramError(Exception):
    """A program did not draw, or did not say how long it took."""


@dataclass(frozen=True)
class Job:
    """A scene to draw. `tachyon` is None where the scene holds more than spheres; `is_mesh`: it holds one mesh."""
    name: str
    povray: object
    tachyon: object
    width: int
    height: int
    is_mesh: bool = False


def run(command):
    """What a program said, on both outputs, and the share of the processor that it got."""
    # Programs that ask for the user's settings find none: all run with their own defaults.
    surroundings = dict(os.environ, HOME='/nonexistent')
    begun = time.monotonic()
    try:
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   env=surroundings)
    except OSError as error:
        raise ProgramError(f'{command[0]}: {error.strerror}') from error
    words = process.stdout.read().decode(errors='replace')
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    share = min(1.0, (used.ru_utime + used.ru_stime) / (time.monotonic() - begun))
    if process.returncode != 0:
        lines = words.strip().splitlines()
        raise ProgramError(f'{command[0]}: exit {process.returncode}: {lines[-1] if lines else ""}')
    return words, share


def figures(run_of):
    """All that has the form `name: number`; of the time to trace, what was the program's own."""
    words, share = run_of
    found = {name: float(value)
             for name, value in re.findall(r'(\w+): ([-+.\d]+(?:e[-+]?\d+)?)(?= |$)', words, re.M)}
    return dict(found, trace=found['trace'] * share) if 'trace' in found else found


def seconds(words, pattern, program):
    found = re.search(pattern, words, re.S)
    if not found:
        raise ProgramError(f'{program} did not say how long it traced')
    return float(found[1])


class Program:
    """draw(job, picture) gives a dictionary with at least `trace`, in seconds."""
    name = ''
    ending = 'ppm'
    spheres_only = False

    def __init__(self, path):
        self.path = path

    def is_there(self):
        return shutil.which(self.path) is not None

    def can_draw(self, job):
        return job.tachyon is not None or not self.spheres_only


class Povtrace(Program):
    name, ending = 'povtrace', 'pfm'

    def draw(self, job, picture=None, options=()):
        found = figures(run([self.path, job.povray, job.width, job.height, picture or '/dev/null', '--format', 'pfm',
                             '--threads', 1, '--stats', '--progress', 'none', *options]))
        return dict(found, trace=found['trace_cpu'])


class PovRay(Program):
    name, ending = 'POV-Ray', 'png'

    def draw(self, job, picture=None):
        output = [f'+O{picture}', '+FN16', 'File_Gamma=1.0'] if picture else ['-F']
        words, _ = run([self.path, f'+I{job.povray}', *output, f'+W{job.width}', f'+H{job.height}', '-A', '-D', '-V',
                        '+WT1'])
        # It sleeps at its start, so that its share says nothing, but it counts the time of its own thread.
        return {'trace': seconds(words, r'Trace Time:.*?with ([\d.]+) CPU-seconds', self.name)}


class Tachyon(Program):
    name, spheres_only = 'Tachyon', True

    def draw(self, job, picture=None):
        output = ['-format', 'PPM48', '-o', picture] if picture else ['-nosave']
        words, share = run([self.path, job.tachyon, *output, '-shade_phong', '-numthreads', 1])
        return {'trace': seconds(words, r'Ray Tracing Time: +([\d.]+) seconds', self.name) * share}


class Embree(Program):
    spheres_only = True

    def __init__(self, path, packet=1):
        super().__init__(path)
        self.packet = packet
        self.name = f'Embree x{packet}' if packet > 1 else 'Embree'

    def can_draw(self, job):
        return job.is_mesh or super().can_draw(job)

    def draw(self, job, picture=None):
        output = [picture] if picture else []
        return figures(run([self.path, job.povray, job.width, job.height, *output, '--packet', self.packet]))
