"""Builds the compiled part with CMake; all else is in pyproject.toml.

Environment:
    SIGNORINI_CMAKE_FOLDER      a build folder to use again (build/python)
    CMAKE_ARGS                  further options for CMake
    CMAKE_BUILD_PARALLEL_LEVEL  compilers at once (all processors)
"""

import importlib.util
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


def version():
    """The one of the project, in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    pattern = r"project\(signorini\s+VERSION ([\d.]+)"
    return re.search(pattern, text).group(1)


def require_wheel():
    """What makes wheels: a package of its own for setuptools before 70.1.

    pip brings it (pyproject.toml), but for --no-build-isolation.
    """
    wanted = {"bdist_wheel", "dist_info"} & set(sys.argv)
    makers = ["setuptools.command.bdist_wheel", "wheel"]
    if wanted and not any(map(importlib.util.find_spec, makers)):
        sys.exit("setup.py: this Python lacks the package wheel, which builds "
                 "without isolation need: pip install wheel, or apt-get "
                 "install python3-wheel")


class BuildWithCMake(build_ext):
    """Calls CMake in place of a compiler."""

    def build_extension(self, ext):
        usual = ROOT / "build" / "python"
        folder = Path(os.environ.get("SIGNORINI_CMAKE_FOLDER", usual))
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            "-DSIGNORINI_BUILD_PYTHON=ON",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]
        if not (folder / "CMakeCache.txt").exists():
            options += [
                "-DSIGNORINI_BUILD_CLI=OFF",
                "-DSIGNORINI_BUILD_TESTS=OFF",
                "-DSIGNORINI_BUILD_BENCHMARKS=OFF",
                # A floor is one file: headers of libraries take the time.
                "-DCMAKE_UNITY_BUILD=ON",
                "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0",
                "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG",
            ]
            if shutil.which("ninja"):
                options.append("-GNinja")
        options += self.pybind11()
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL",
                              str(os.cpu_count() or 1))
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, *options],
                       check=True)
        subprocess.run(["cmake", "--build", folder, "--target",
                        "signorini-python", "--parallel", jobs], check=True)
        built = folder / "python" / "signorini"
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built / target.name, target)

    @staticmethod
    def pybind11():
        """Where pip's pybind11 has its CMake files; Debian's are found."""
        try:
            import pybind11
        except ImportError:
            return []
        return [f"-Dpybind11_DIR={pybind11.get_cmake_dir()}"]


require_wheel()
setup(version=version(),
      ext_modules=[Extension("signorini._core", sources=[])],
      cmdclass={"build_ext": BuildWithCMake})
