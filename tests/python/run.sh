#!/bin/sh
# The Python package: in place, and installed by pip in a fresh environment. What is not installed is skipped.
. "$(dirname "$0")/../support/cases.sh"

POVTRACE_LIBRARY=$BUILD_DIR/lib/libpovtrace.so.0
export POVTRACE_LIBRARY

python_draws_and_traces() {
    "$PYTHON" -c 'import cffi, numpy' 2> /dev/null || skip "no cffi and numpy (PyPI) for $PYTHON"
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/bindings/python "$PYTHON" "$root/tests/python/test_scene.py" "$povc"
}

# A compiler that fails shows that none is needed.
python_package_installs_without_a_compiler() {
    "$PYTHON" -m venv env > log 2>&1 || skip "no venv for $PYTHON"
    env/bin/pip download -q --no-deps 'setuptools>=68' > log 2>&1 || skip "PyPI is not reached"
    cp -r "$root/bindings/python" package
    CC=false env/bin/pip install -q ./package
    env/bin/python "$root/tests/python/test_scene.py" "$povc"
}

run_cases_of "$root/tests/python/run.sh" python
end_cases
