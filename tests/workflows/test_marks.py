"""Marks of photographs that are left out as copies count in those that stay."""

from pathlib import Path

import numpy as np

from raybundle.io.geo.control_files import ControlFile, Measurements
from raybundle.placing.marks import under_kept_names


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
