#!/bin/sh
# The Python package: in place, and installed by pip in a fresh environment. What is not installed is skipped.
. "$(dirname "$0")/../support/cases.sh"

POVTRACE_LIBRARY=$BUILD_DIR/lib/libpovtrace.so.0
export POVTRACE_LIBRARY

python_draws_and_traces() {
    "$PYTHON" -c 'import cffi, numpy' 2> /dev/null || skip "no cffi and numpy (PyPI) for $PYTHON"
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/bindings/python "$PYTHON" "$root/tests/python/test_scene.py" "$povc"
}

# A wheel with the library inside, installed where there is no compiler, and without the build.
python_wheel_draws_without_a_compiler() {
    "$PYTHON" -m venv env > log 2>&1 || skip "no venv for $PYTHON"
    env/bin/pip install -q cffi numpy 'setuptools>=70' wheel > log 2>&1 || skip "PyPI is not reached"
    cp -r "$root/bindings/python" package
    POVTRACE_BUILD=$BUILD_DIR env/bin/pip wheel -q --no-deps --no-build-isolation -w wheels ./package
    unset POVTRACE_LIBRARY
    env PATH=/nowhere env/bin/python -m pip install -q --no-index --no-deps wheels/*.whl
    env/bin/python "$root/tests/python/test_scene.py" "$povc"
    env/bin/python "$root/bindings/python/examples/lattice.py" lattice.png > out
    says out "27 objects"
    env/bin/python "$root/bindings/python/examples/heights.py" heights.png > out
    says out "largest difference between the mesh and the function: 0.00"
    [ -s lattice.png ] && [ -s heights.png ] || fail "no pictures"
    env/bin/pip install -q ase > log 2>&1 || skip "ase is not to be had from PyPI"
    env/bin/python "$root/bindings/python/examples/molecule.py" CH3CH2OH molecule.png
    [ -s molecule.png ] || fail "no molecule"
}

run_cases_of "$root/tests/python/run.sh" python
end_cases
