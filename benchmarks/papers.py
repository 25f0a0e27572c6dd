# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of the four papers, reproduced: each paper's table next to ours.

    ./dev bench papers [KEY ...]     all papers, or only lm15, eas07, hqs24, cs08

With $SPIRALPOCKET_POCKETS, a folder of pockets as JSON, their shapes are used where a paper
prints none (see paper_pockets.py). The last line is one JSON object with a key for each paper.
"""

from __future__ import annotations

import json
import sys
from importlib import import_module

#: Each paper has a module paper_KEY with a function `figures`, which prints and returns.
KEYS = ("lm15", "eas07", "hqs24", "cs08")


def main(wanted: list[str]) -> None:
    """Print the tables of the papers that are wanted, all without any."""
    found = {}
    for key in wanted or KEYS:
        print(f"== {key}")
        found[key] = import_module(f"paper_{key}").figures()
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1:])
