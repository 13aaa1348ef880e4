"""Marks of photographs that are left out as copies count in those that stay."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from raybundle.adjustment.records.severity import Severity
from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.placing.marks import Given, Placing, add_points, under_kept_names
from tests.workflows.free_flight import control, flight

__all__ = ["flight"]


def test_marks_in_a_copy_count_in_the_photograph_that_stays():
    marks = Measurements(
        image=("DSC_1 (1).JPG", "b.jpg", "sub/DSC_1 (1).JPG", "DSC_1.JPG"), point=np.array([0, 0, 1, 1], np.int32),
        xy_px=np.arange(8.0).reshape(4, 2), line=np.arange(2, 6, dtype=np.int32),
    )  # fmt: skip
    control = ControlFile(
        path=Path("control.csv"), crs=None, ids=("A", "B"), xyz=np.zeros((2, 3)), sigma=np.ones((2, 3)),
        role=np.ones(2, np.int32), measurements=marks,
    )  # fmt: skip
    (kept,) = under_kept_names((control,), {"DSC_1 (1).JPG": "DSC_1.JPG"})
    # of B marked in both, the first
    assert kept.measurements.image == ("DSC_1.JPG", "b.jpg", "DSC_1.JPG")
    assert kept.measurements.point.tolist() == [0, 0, 1]
    assert kept.measurements.xy_px.tolist() == [[0, 1], [2, 3], [4, 5]]
    assert kept.measurements.line.tolist() == [2, 3, 4]
    assert under_kept_names((control,), {}) == (control,)


def test_measurements_of_photographs_that_are_not_here_are_a_remark_where_others_are(flight):
    """A file of two epochs has measurements in photographs of the other one: nothing is wrong with it."""

    def told(rename):
        m = flight.marks
        marks = replace(m, image=tuple(rename(name) for name in m.image))
        state = Placing(block=flight.free)
        add_points(state, flight.photos, Given(control=(control(flight, marks=marks),)), None)
        return [n for n in state.notices if n.code == "control_without_photograph"]

    first = flight.marks.image[0]
    count = sum(name == first for name in flight.marks.image)
    (some,) = told(lambda name: "elsewhere.jpg" if name == first else name)
    assert some.severity is Severity.NOTE
    assert some.values == {"n": count, "table": "control.csv", "names": ["elsewhere.jpg"]}
    (none,) = told(lambda name: f"of-another-flight-{name}")
    assert none.severity is Severity.WARNING
    assert not told(lambda name: name)
