"""Builds the C library beside the package, so that a wheel needs no compiler where it is installed.

POVTRACE_BUILD names a folder that `make` has already built into; without it, `make` runs in the tree around this folder.
"""
import os
import shutil
import subprocess
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

TREE = Path(__file__).resolve().parents[2]


def built() -> Path:
    given = os.environ.get("POVTRACE_BUILD")
    if given:
        return Path(given)
    subprocess.run(["make", "-C", str(TREE), "runtime"], check=True)
    return TREE / "build"


class BuildWithLibrary(build_py):
    def run(self) -> None:
        super().run()
        to, build = Path(self.build_lib) / "povtrace" / "lib", built()
        shutil.rmtree(to, ignore_errors=True)
        shutil.copytree(build / "lib", to, ignore=shutil.ignore_patterns("*.a", "pkgconfig", "cmake"))
        include = build / "share" / "povtrace"
        if include.is_dir():
            shutil.copytree(include, to.parent / "share" / "povtrace", dirs_exist_ok=True)


class WithLibrary(Distribution):
    """Wheels are for one platform, though for any Python."""

    def has_ext_modules(self) -> bool:
        return True


def platform_wheel():
    try:
        from setuptools.command.bdist_wheel import bdist_wheel
    except ImportError:
        from wheel.bdist_wheel import bdist_wheel

    class PlatformWheel(bdist_wheel):
        def get_tag(self):
            return "py3", "none", super().get_tag()[2]

    return PlatformWheel


setup(cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": platform_wheel()}, distclass=WithLibrary)
