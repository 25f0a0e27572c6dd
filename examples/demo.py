# SPDX-License-Identifier: LGPL-2.1-or-later
"""Machine the sample rib: all nine pockets with a 12 mm end mill, and post the job.

Shows the scripting interface, and is what ``./dev demo`` runs inside FreeCAD. The
files go to the folder given as the first argument, or in $SPIRALPOCKET_OUT.
"""

import os
import sys
from pathlib import Path

import FreeCAD
import Part

from freecad_spiralpocket import api, picture
from freecad_spiralpocket.op import compat, results
from freecad_spiralpocket.op.floors import find_floors

HERE = Path(__file__).resolve().parent

DIAMETER = 12.0  # mm
FEED, PLUNGE, RAPID = 3000.0, 600.0, 10000.0  # mm/min
SPINDLE = 12000.0  # 1/min
POSTS = {"rib-linuxcnc.ngc": "linuxcnc", "rib-grbl.gcode": "grbl"}


def make_job(document):
    """Return a job for the rib with one end mill, its stock flush with the rib's top."""
    rib = document.addObject("Part::Feature", "Rib")
    rib.Shape = Part.read(str(HERE / "rib.step"))
    document.recompute()
    job = compat.PathJob.Create("Job", [rib], None)
    job.Stock.ExtZpos = 0
    controller = job.Tools.Group[0]
    compat.set_end_mill(controller, DIAMETER)
    controller.HorizFeed, controller.VertFeed = FEED / 60, PLUNGE / 60
    job.SetupSheet.HorizRapid = job.SetupSheet.VertRapid = RAPID / 60
    controller.SpindleSpeed = SPINDLE
    document.recompute()
    return job


def main(folder):
    """Machine the rib, write everything into `folder`, and return the operation."""
    folder.mkdir(parents=True, exist_ok=True)
    document = FreeCAD.newDocument("Rib")
    job = make_job(document)
    model = job.Model.Group[0]
    floors = sorted(find_floors(model), key=lambda f: f.face.BoundBox.XMin)
    op = api.add_spiral_pocket(job, [(model, [f.name for f in floors])])

    written = ["rib.FCStd", "rib.png", *POSTS]
    document.saveAs(str(folder / "rib.FCStd"))
    picture.draw(op.Proxy.plans, folder / "rib.png", "Rib, nine pockets, 12 mm end mill")
    for name, post in POSTS.items():
        api.export(job, folder / name, post)

    print(f"\n{len(op.Proxy.plans)} pockets of the rib, {DIAMETER:g} mm end mill")
    print("\n".join(results.summary(op)))
    print("\n".join(f"wrote {folder / name}" for name in written))
    return op


if __name__ == "__main__":
    default = os.environ.get("SPIRALPOCKET_OUT") or "build/demo"
    main(Path(sys.argv[1] if len(sys.argv) > 1 else default).resolve())
