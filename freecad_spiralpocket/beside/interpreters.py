# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which Python interpreters may run a process beside this FreeCAD, and on how many cores.

It must be the one that FreeCAD carries, or one with the same libraries in the same
versions: the path must not depend on where it was planned. Whether that is so is known
when it has told its `versions`; until then an interpreter is only likely.
"""

from __future__ import annotations

import os
import shutil
import sys
from importlib import import_module
from pathlib import Path

#: What they run.
SCRIPT = Path(__file__).with_name("process.py")


class Interpreters:
    """Which interpreters are left to try; the first is the one in use."""

    left: list[str] | None = None

    @classmethod
    def best(cls) -> str | None:
        """Return the one to use, None for none."""
        if cls.left is None:
            cls.left = likely()
        return cls.left[0] if cls.left else None

    @classmethod
    def refuse(cls, python: str) -> None:
        """Leave one out from now on."""
        cls.left = [p for p in cls.left or () if p != python]


def likely() -> list[str]:
    """Return the Python interpreters that may belong to this FreeCAD, the likeliest first."""
    names = [f"python{sys.version_info[0]}.{sys.version_info[1]}", "python3", "python"]
    folders = [
        *_freecads_own(),
        Path(sys.exec_prefix, "bin"),
        Path(sys.exec_prefix),
        # where FreeCAD's own program is, if Python tells that
        *([Path(sys.executable).parent] if sys.executable else []),
    ]
    suffix = ".exe" if os.name == "nt" else ""
    found = [folder / (name + suffix) for folder in folders for name in names]
    paths = [str(path) for path in found if os.access(path, os.X_OK) and path.is_file()]
    paths += filter(None, map(shutil.which, names))
    return list(dict.fromkeys(paths))


def cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def newest_source() -> float:
    """Return when the newest of the add-on's files was written [s]."""
    folder = Path(__file__).resolve().parents[1]
    return max(path.stat().st_mtime for path in folder.rglob("*.py"))


#: As it was when this was loaded: an update while FreeCAD runs must not mix old and new records.
LOADED = newest_source()


def versions() -> tuple[str, ...]:
    """Return what must be the same here and in FreeCAD for the same path to come out."""
    python = f"{sys.version_info[0]}.{sys.version_info[1]}"
    return python, *map(_version, ("numpy", "scipy", "shapely")), str(LOADED)


def _freecads_own() -> list[Path]:
    """Return the folder of FreeCAD's programs; none in plain Python."""
    freecad = sys.modules.get("FreeCAD")
    return [Path(freecad.getHomePath(), "bin")] if freecad else []


def _version(library: str) -> str:
    """Return a library's version, without loading it if that can be: scipy takes half a second."""
    from importlib import metadata  # takes 7 ms, which planning one pocket does without

    try:
        return metadata.version(library)
    except metadata.PackageNotFoundError:
        return str(import_module(library).__version__)
