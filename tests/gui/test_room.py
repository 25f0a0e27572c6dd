# SPDX-License-Identifier: LGPL-2.1-or-later
"""All of the panel can be read with large letters, long words and little room."""

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from window import (
    CANCEL,
    main_window,
    panel,
    press,
    press_toolbar_button,
    pump,
    select,
    set_units,
    settle,
    widget,
)

from freecad_spiralpocket.gui.compat import TASK_DOCKS
from freecad_spiralpocket.gui.preview.legend import Swatches

MILLIMETERS, INCHES = 0, 3  # FreeCAD's numbers for them
NARROW = 300  # pixels
CHOICES = ("strategy", "cutMode", "machine", "feedMode")


@pytest.fixture(
    params=[
        ("English", 0, NARROW, MILLIMETERS),
        ("English", 0, 0, INCHES),
        ("German", 15, 0, MILLIMETERS),
        ("Spanish", 15, 0, INCHES),
    ]
)
def form(request, job, floor):
    """Return the page of a new operation in a language, a size of letters, a width and units."""
    language, size, width, units = request.param
    set_units(job.Document, units)
    application = QtGui.QApplication.instance()
    before, large = application.font(), application.font()
    if size:
        large.setPointSize(size)
    FreeCADGui.setLocale(language)
    application.setFont(large)
    select(floor)
    press_toolbar_button()
    widget("advanced").setChecked(True)
    settle()
    pump(0.5)
    if width:
        set_width(width)
    yield panel().operation_page.form
    press(CANCEL)
    application.setFont(before)
    FreeCADGui.setLocale("English")
    FreeCAD.Units.setSchema(MILLIMETERS)
    pump(0.3)


def set_width(width):
    """Make the dock of the panel so wide."""
    over_the_view = main_window().findChild(QtGui.QTabWidget, "OverlayRight")
    if over_the_view is not None and over_the_view.isVisible():
        place = over_the_view.geometry()
        place.setLeft(place.right() - width + 1)
        over_the_view.setGeometry(place)
    else:
        docks = [main_window().findChild(QtGui.QDockWidget, name) for name in TASK_DOCKS]
        main_window().resizeDocks([d for d in docks if d], [width], QtCore.Qt.Horizontal)
    pump(0.3)


def room_for_text(box):
    """Return how wide the text of a combo box may be."""
    option = QtGui.QStyleOptionComboBox()
    box.initStyleOption(option)
    style = box.style()
    field = QtGui.QStyle.SC_ComboBoxEditField
    return style.subControlRect(QtGui.QStyle.CC_ComboBox, option, field, box).width()


def test_nothing_is_cut_off(form):
    for shown in panel().form:
        visible = shown.visibleRegion().boundingRect()
        assert visible.isEmpty() or visible.width() == shown.width()
    over_the_view = main_window().findChild(QtGui.QTabWidget, "OverlayRight")
    if over_the_view is None:  # else FreeCAD keeps the width, and the page may be scrolled
        assert form.visibleRegion().boundingRect().width() == form.width()
    assert form.width() >= form.minimumSizeHint().width()
    for name in CHOICES:
        box = getattr(form, name)
        texts = [box.itemText(i) for i in range(box.count())]
        assert max(map(box.fontMetrics().horizontalAdvance, texts)) <= room_for_text(box), name
    for box in form.findChildren(QtGui.QAbstractSpinBox):
        if box.isVisible():
            text = box.fontMetrics().horizontalAdvance(box.text())
            assert text + 3.4 * box.fontMetrics().height() < box.width(), box.objectName()


@pytest.mark.parametrize("width", [180, 230, 400])
def test_preview_box_crushes_nothing(job, floor, width):
    select(floor)
    press_toolbar_button()
    box = panel().operation_page.preview.box
    box.setParent(None)
    box.show()
    box.resize(width, box.heightForWidth(width) if box.hasHeightForWidth() else 0)
    pump(0.2)
    for shown in (box.live, box.quantity, box.slider):
        assert shown.height() >= shown.minimumSizeHint().height()
    box.hide()
    press(CANCEL)


def test_names_of_colors_do_not_run_into_each_other(form):
    legend = panel().operation_page.preview.box.findChild(Swatches)
    columns = legend.columns(legend.width())
    assert columns * legend.widest <= legend.width()
    assert legend.height() >= legend.height_of(columns)
