"""Marks of control and check points in their images."""

import numpy as np

from raybundle.block import Role
from raybundle.report.figures.control import MOST_IMAGES, marked_images, marks_figure
from raybundle.report.view import view_of


def test_every_mark_is_drawn_with_its_residual(case):
    view = view_of(case("rich"))
    rows, images = marked_images(view)
    roles = np.asarray(view.given.points.role)[view.given.observations.point]
    assert len(rows) == int((roles != Role.TIE).sum())
    assert len(images) <= MOST_IMAGES
    figure, reference = marks_figure(view)
    svg = str(figure.svg)
    shown = np.isin(view.given.observations.image[rows], images)
    assert svg.count('class="control"') == int((roles[rows][shown] == Role.CONTROL).sum())
    assert svg.count('class="check"') == int((roles[rows][shown] == Role.CHECK).sum())
    residual = np.linalg.norm(view.adjustment.image_observations.residuals_px[rows], axis=1)
    assert reference <= np.nanquantile(residual, 0.9)
    assert "nan" not in svg


def test_without_control_there_is_no_figure(case):
    assert marks_figure(view_of(case("free"))) is None
