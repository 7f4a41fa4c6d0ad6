#!/bin/sh
# The Python package: in place, and installed by pip in a fresh environment. What is not installed is skipped.
. "$(dirname "$0")/../support/cases.sh"

POVTRACE_LIBRARY=$BUILD_DIR/lib/libpovtrace.so.0
export POVTRACE_LIBRARY

python_draws_and_traces() {
    "$PYTHON" -c 'import cffi, numpy' 2> /dev/null || skip "no cffi and numpy (PyPI) for $PYTHON"
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/bindings/python "$PYTHON" "$root/tests/python/test_scene.py" "$povc"
}

python_builds_scenes_from_arrays() {
    "$PYTHON" -c 'import cffi, numpy' 2> /dev/null || skip "no cffi and numpy (PyPI) for $PYTHON"
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/bindings/python "$PYTHON" "$root/tests/python/test_builder.py"
}

python_package_is_typed() {
    "$PYTHON" -c 'import cffi, mypy, numpy' 2> /dev/null || skip "no cffi, mypy and numpy (PyPI) for $PYTHON"
    cat > use.py <<'END'
import numpy as np
import povtrace

builder = povtrace.Builder().spheres(np.zeros((2, 3)), 1, "pigment { rgb 1 }", colors=[[1, 0, 0], [0, 1, 0]])
scene = povtrace.Scene(builder.mesh(np.eye(3), [[0, 1, 2]], uv=np.eye(3)[:, :2]))
first: float = scene.trace([0, 0, -5], [0, 0, 1]).distance[0]
png: bytes = scene.render(8, 6).png()
END
    MYPYPATH=$root/bindings/python "$PYTHON" -m mypy --cache-dir mypy --disallow-untyped-defs --ignore-missing-imports use.py > out ||
        fail "$(cat out)"
    echo 'povtrace.Builder().spheres(centers=[])' >> use.py
    expect 1 env MYPYPATH="$root/bindings/python" "$PYTHON" -m mypy --cache-dir mypy --ignore-missing-imports use.py
    says out 'Unexpected keyword argument "centers"'
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
    env/bin/python "$root/tests/python/test_builder.py"
    env/bin/python "$root/bindings/python/examples/lattice.py" lattice.png > out
    says out "27 objects"
    env/bin/python "$root/bindings/python/examples/heights.py" heights.png > out
    says out "largest difference between the mesh and the function: 0.00"
    [ -s lattice.png ] && [ -s heights.png ] || fail "no pictures"
    env/bin/pip install -q ase > log 2>&1 || skip "ase is not to be had from PyPI"
    env/bin/python "$root/bindings/python/examples/molecule.py" CH3CH2OH molecule.png > out
    says out "17 objects: 9 atoms and 8 bonds"
    [ -s molecule.png ] || fail "no molecule"
}

run_cases_of "$root/tests/python/run.sh" python
end_cases
