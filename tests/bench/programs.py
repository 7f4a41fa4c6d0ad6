"""The programs that the bench runs: how each is called, and where it says how long it traced.

One thread, one sample a pixel; a timed run writes no file. What counts is the time of tracing as each program measures
it itself: no start, parsing, building or writing.
"""
import os
import re
import shutil
import subprocess
from dataclasses import dataclass


class ProgramError(Exception):
    """A program did not draw, or did not say how long it took."""


@dataclass(frozen=True)
class Job:
    """A scene to draw. `tachyon` is None where the scene holds more than spheres."""
    name: str
    povray: object
    tachyon: object
    width: int
    height: int


def run(command):
    """What a program said, on both outputs."""
    # Programs that ask for the user's settings find none: all run with their own defaults.
    surroundings = dict(os.environ, HOME='/nonexistent')
    try:
        result = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                errors='replace', env=surroundings)
    except OSError as error:
        raise ProgramError(f'{command[0]}: {error.strerror}') from error
    if result.returncode != 0:
        lines = result.stdout.strip().splitlines()
        raise ProgramError(f'{command[0]}: exit {result.returncode}: {lines[-1] if lines else ""}')
    return result.stdout


def figures(words):
    """All that has the form `name: number`."""
    return {name: float(value) for name, value in re.findall(r'(\w+): ([-+.\d]+(?:e[-+]?\d+)?)(?= |$)', words, re.M)}


def seconds(words, pattern, program):
    found = re.search(pattern, words)
    if not found:
        raise ProgramError(f'{program} did not say how long it traced')
    return {'trace': float(found[1])}


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
        return figures(run([self.path, job.povray, job.width, job.height, picture or '/dev/null', '--format', 'pfm',
                            '--threads', 1, '--stats', '--progress', 'none', *options]))


class PovRay(Program):
    name, ending = 'POV-Ray', 'png'

    def draw(self, job, picture=None):
        output = [f'+O{picture}', '+FN16', 'File_Gamma=1.0'] if picture else ['-F']
        words = run([self.path, f'+I{job.povray}', *output, f'+W{job.width}', f'+H{job.height}', '-A', '-D', '-V',
                     '+WT1'])
        return seconds(words, r'Trace Time:.*\(([\d.]+) seconds\)', self.name)


class Tachyon(Program):
    name, spheres_only = 'Tachyon', True

    def draw(self, job, picture=None):
        output = ['-format', 'PPM48', '-o', picture] if picture else ['-nosave']
        words = run([self.path, job.tachyon, *output, '-shade_phong', '-numthreads', 1])
        return seconds(words, r'Ray Tracing Time: +([\d.]+) seconds', self.name)


class Embree(Program):
    spheres_only = True

    def __init__(self, path, packet=1):
        super().__init__(path)
        self.packet = packet
        self.name = f'Embree x{packet}' if packet > 1 else 'Embree'

    def draw(self, job, picture=None):
        output = [picture] if picture else []
        return figures(run([self.path, job.povray, job.width, job.height, *output, '--packet', self.packet]))
