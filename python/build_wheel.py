"""Builds the wheel of cleave (PEP 517): CMake makes and installs the package, this zips it.

It needs cmake, a C++20 compiler and Boost's headers on the system. pybind11 may be the system's or
come from pip.
"""

import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

try:
    import tomllib
except ModuleNotFoundError:  # Python below 3.11: pip brings its own copy
    from pip._vendor import tomli as tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent


def get_requires_for_build_wheel(config_settings=None):
    """pybind11, unless CMake finds it on the system."""
    del config_settings
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "CMakeLists.txt"
        source.write_text("cmake_minimum_required(VERSION 3.25)\nproject(probe LANGUAGES CXX)\n"
                          "set(PYBIND11_NOPYTHON ON)\n"
                          "find_package(pybind11 2.10 CONFIG REQUIRED)\n")
        probe = subprocess.run(["cmake", "-S", folder, "-B", f"{folder}/build"],
                               capture_output=True, check=False)
    return [] if probe.returncode == 0 else ["pybind11>=2.10"]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes cleave-VERSION-TAG.whl into `wheel_directory`; returns its name."""
    del config_settings, metadata_directory
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    name = f"{project['name']}-{project['version']}-{tag}-{tag}-{platform}.whl"
    with tempfile.TemporaryDirectory() as folder:
        staging = pathlib.Path(folder) / "staging"
        _install(pathlib.Path(folder) / "build", staging)
        info = staging / f"{project['name']}-{project['version']}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(_metadata(project), encoding="utf-8")
        (info / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: build_wheel\n"
                                    f"Root-Is-Purelib: false\nTag: {tag}-{tag}-{platform}\n")
        shutil.copy(ROOT / "LICENSE", info / "LICENSE")
        _zip(staging, info, pathlib.Path(wheel_directory) / name)
    return name


def _install(build, staging):
    configure = ["cmake", "-S", str(ROOT), "-B", str(build), "-DCMAKE_BUILD_TYPE=Release",
                 "-DCLEAVE_PYTHON=ON", "-DCLEAVE_CUTTING=OFF", "-DCLEAVE_FEM=OFF",
                 "-DCLEAVE_APP=OFF", "-DCLEAVE_TESTS=OFF",
                 f"-DPython3_EXECUTABLE={sys.executable}", f"-DPython_EXECUTABLE={sys.executable}"]
    if shutil.which("ccache"):
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    if shutil.which("ninja"):
        configure += ["-G", "Ninja"]
    try:
        import pybind11
        configure.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
    except ImportError:
        pass  # the system's
    for command in (configure,
                    ["cmake", "--build", str(build), "--parallel", str(os.cpu_count() or 1)],
                    ["cmake", "--install", str(build), "--prefix", str(staging),
                     "--component", "python", "--strip"]):
        try:
            subprocess.run(command, check=True)
        except FileNotFoundError as missing:
            raise RuntimeError("cleave is built by CMake 3.25 or later: please install cmake, a "
                               "C++20 compiler and Boost's headers") from missing


def _metadata(project):
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {requirement}" for requirement in project["dependencies"]]
    for extra, requirements in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f"Requires-Dist: {r}; extra == '{extra}'" for r in requirements]
    lines.append("Description-Content-Type: text/markdown")
    return "\n".join(lines) + "\n\n" + (ROOT / project["readme"]).read_text(encoding="utf-8")


def _zip(staging, info, path):
    record = []
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file in sorted(p for p in staging.rglob("*") if p.is_file()):
            content = file.read_bytes()
            place = file.relative_to(staging).as_posix()
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=")
            record.append(f"{place},sha256={digest.decode()},{len(content)}")
            wheel.writestr(place, content)
        place = (info / "RECORD").relative_to(staging).as_posix()
        wheel.writestr(place, "\n".join([*record, f"{place},,"]) + "\n")
