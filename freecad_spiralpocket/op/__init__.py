# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document side of Spiral Pocket: works with and without FreeCAD's window.

`operation` holds the CAM operation, `pockets` all pockets of one together; `properties`,
`selection`, `geometry`, `request` and `commands` each do one step of its way from the selected
faces to the path; `compat` knows what differs between the versions of FreeCAD.
"""
