"""Images that stand out among those of their camera, by F of their square sums."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import f

from raybundle.adjustment.blunders.image_fields import own_field_notices
from raybundle.adjustment.blunders.wrong_images import ALPHA, outlying
from raybundle.adjustment.records.severity import Severity
from raybundle.adjustment.statistics.field_test import OwnField

N, DIRECTIONS = 16, 8
FAULT = Severity.FAULT


def square_sums(**wrong):
    """Of images with mean squares of one, but for some: number -> ratio of standard deviations."""
    T = np.full(N, float(DIRECTIONS))
    for name, ratio in wrong.items():
        T[int(name[1:])] *= ratio**2
    return T


def named(T, may=None):
    left = np.full(N, float(DIRECTIONS))
    return outlying(np.arange(N), T, left, np.ones(N, bool) if may is None else may)


def test_one_is_named_with_its_ratio_and_probability():
    (found,) = named(square_sums(i4=4.0))
    assert found.image == 4
    assert found.ratio == pytest.approx(4.0)
    assert found.limit == ALPHA / N
    # of an image three directions count, as smooth errors have few
    assert found.probability == pytest.approx(f.sf(16.0, 3, 3 * (N - 1)))


def test_from_three_times_the_others_on_and_by_no_chance():
    least = np.sqrt(max(f.isf(ALPHA / N, 3, 3 * (N - 1)), 9.0))
    assert named(square_sums(i4=1.001 * least))
    assert not named(square_sums(i4=0.999 * least))
    assert not named(square_sums(i4=9.0), may=np.arange(N) != 4)


def test_a_third_at_most_each_against_the_others():
    three = square_sums(i2=5.0, i7=6.0, i11=4.5)
    assert [w.image for w in named(three)] == [7, 2, 11]
    assert [w.ratio for w in named(three)] == pytest.approx([6.0, 5.0, 4.5])
    assert len(named(square_sums(**{f"i{k}": 6.0 for k in range(5)}))) == 5
    assert not named(square_sums(**{f"i{k}": 6.0 for k in range(6)}))


class Images(SimpleNamespace):
    def __len__(self):
        return len(self.ids)


def stated(rms, notices=(), camera=None):
    """Notices of fields of which image 4 has four times the others' mean square, each image with this rms."""
    T = square_sums(i4=4.0)
    fields = [OwnField(image=k, square=T[k], directions=DIRECTIONS, rms_px=rms) for k in range(N)]
    images = Images(ids=tuple("abcdefghijklmnop"), camera=np.zeros(N, int) if camera is None else camera)
    cameras = [SimpleNamespace(id=str(k), width_px=4000, height_px=6000) for k in range(2)]
    return own_field_notices(
        SimpleNamespace(
            notices=notices, given=SimpleNamespace(images=images, cameras=cameras),
            handle=SimpleNamespace(work=SimpleNamespace(spread=SimpleNamespace(own_fields=fields))),
        )
    )  # fmt: skip


def test_a_field_is_a_fault_from_one_percent_of_half_the_longer_side_on():
    (notice,) = stated(30.1)
    assert notice.ids == ("e",)
    values = {"image": "e", "camera": "0", "ratio": 4.0, "limit": 3.0, "rms_px": 30.1, "limit_px": 30.0}
    assert notice.values == pytest.approx(values)
    assert not stated(29.9)
    assert not stated(30.1, notices=(SimpleNamespace(severity=FAULT, code="control_suspect", ids=()),))
    assert not stated(30.1, notices=(SimpleNamespace(severity=FAULT, code="image_contradicts", ids=("e",)),))
    assert stated(30.1, notices=(SimpleNamespace(severity=FAULT, code="image_contradicts", ids=("a",)),))
    assert stated(30.1, camera=np.arange(N) % 2)[0].values["camera"] == "0"
    assert stated(30.1, camera=(np.arange(N) + 1) % 2)[0].values["camera"] == "1"
