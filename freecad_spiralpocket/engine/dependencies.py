# SPDX-License-Identifier: LGPL-2.1-or-later
"""Says in one sentence which library is missing or too old, before anything else fails.

FreeCAD's own packages do not always carry shapely and scipy (Debian, Flatpak),
and Debian 12 has a shapely that is too old.
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from types import ModuleType

from .errors import SetupError

_HINT = (
    "Install it with FreeCAD's Addon Manager (it is a dependency of Spiral Pocket) or with pip "
    "into the Python that FreeCAD uses, then start FreeCAD again."
)


def require(name: str, hint: str = _HINT) -> ModuleType:
    """Return the library `name`.

    Raises
    ------
    SetupError
        If it is missing; the message names it.
    """
    try:
        return import_module(name)
    except ImportError as error:
        raise _missing(name, hint) from error


def _missing(name: str, hint: str = _HINT) -> SetupError:
    return SetupError(
        f"Spiral Pocket needs the Python library {name}, which this FreeCAD lacks.", hint
    )


def require_libraries() -> None:
    """Check that numpy, scipy and shapely 2 are there.

    scipy is not loaded: that takes time, and Automatic does without.

    Raises
    ------
    SetupError
        If one is missing or too old; the message names it.
    """
    if find_spec("scipy") is None:
        raise _missing("scipy")
    for name in ("numpy", "shapely"):
        module = require(name)
        # versions cannot be parsed: Debian's build of shapely reports "0+unknown"
        if name == "shapely" and not hasattr(module, "get_coordinates"):
            raise SetupError(
                f"Spiral Pocket needs shapely 2, this FreeCAD has {module.__version__}.", _HINT
            )
