#!/usr/bin/env bash
# Installs the Python package as a user does, and runs its tests and its example against it.
set -euo pipefail
source=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

/usr/bin/python3 -m venv --system-site-packages "$folder/env"
python=$folder/env/bin/python
"$python" -m pip install --quiet --disable-pip-version-check --no-index "$source"
cd "$folder"  # so that the package is the installed one
"$python" -m pytest -q -p no:cacheprovider "$source/tests/python"
"$python" "$source/python/examples/fault.py" | tee example.txt
grep -q '^certified: True$' example.txt
version=$("$python" -c 'import cleave; print(cleave.__version__)')
grep -q "^project(cleave VERSION $version " "$source/CMakeLists.txt"
grep -qx "version = \"$version\"" "$source/pyproject.toml"
"$python" - <<'PYTHON'
import inspect
import pathlib

import cleave

assert pathlib.Path(cleave.__file__).with_name("py.typed").exists()
for name in cleave.__all__:
    assert inspect.getdoc(getattr(cleave, name)), f"{name} has no docstring"
PYTHON
