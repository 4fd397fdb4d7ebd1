"""vendor.py FOLDER: makes an unpacked wheel carry the shared libraries of its compiled module, in signorini.libs.

All but those that every Linux of the last years has (PEP 600); each copy and the module find them by $ORIGIN. The
tag becomes manylinux with the newest version of glibc that any of them asks for. Ends with 1 if something is still
found elsewhere. Needs patchelf, ldd and objdump.
"""

import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

ALLOWED = {"linux-vdso.so.1", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1", "libc.so.6", "libm.so.6", "libdl.so.2",
           "librt.so.1", "libpthread.so.0", "libstdc++.so.6", "libgcc_s.so.1", "libutil.so.1", "libnsl.so.1",
           "libresolv.so.2", "libz.so.1", "libexpat.so.1"}


def written(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def needed(path):
    """Names and places of the libraries that the loader finds for it, but for those of every system."""
    shown = written("ldd", path)
    if missing := re.findall(r"(\S+) => not found", shown):
        raise SystemExit(f"vendor: {path} needs {', '.join(missing)}")
    found = re.findall(r"(\S+) => (/\S+)", shown)
    return {name: Path(place) for name, place in found if name not in ALLOWED}


def glibc(path):
    """The newest version of glibc that it asks for."""
    versions = re.findall(r"GLIBC_(\d+)\.(\d+)", written("objdump", "-T", path))
    return max((int(major), int(minor)) for major, minor in versions)


def main():
    wheel = Path(sys.argv[1]).resolve()
    module, = wheel.glob("signorini/_core.*.so")
    folder = wheel / "signorini.libs"
    folder.mkdir()
    for name, place in needed(module).items():
        shutil.copyfile(place.resolve(), folder / name)
        os.chmod(folder / name, 0o755)
        written("patchelf", "--set-rpath", "$ORIGIN", folder / name)
    # An old-style run path holds for what the libraries need in turn, too.
    written("patchelf", "--force-rpath", "--set-rpath", "$ORIGIN/../signorini.libs", module)
    if outside := [str(place) for place in needed(module).values() if place.parent.resolve() != folder]:
        print("vendor: found elsewhere:", *outside, file=sys.stderr)
        return 1
    major, minor = max(map(glibc, [module, *folder.iterdir()]))
    about, = wheel.glob("*.dist-info/WHEEL")
    tag = f"-manylinux_{major}_{minor}_{platform.machine()}"
    text = re.sub(r"-linux_\w+$", tag, about.read_text(encoding="utf-8"), flags=re.MULTILINE)
    about.write_text(text, encoding="utf-8")
    names = sorted(file.name for file in folder.iterdir())
    size = sum(file.stat().st_size for file in folder.iterdir())
    print(f"vendor: {tag[1:]}, {len(names)} libraries, {size / 1e6:.0f} MB: {' '.join(names)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
