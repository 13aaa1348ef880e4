"""Flight lines by the positions of photographs, and relative aerial control along them."""

from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from types import SimpleNamespace

import numpy as np
import pytest

from raybundle.adjustment.engine import adjust_block
from raybundle.placing.georeference import Georeferenced
from raybundle.placing.positions import flight_lines
from raybundle.planning.flights.uav_networks import Flight, flight_block, uav_camera
from raybundle.workflows.orienting.stages.adjustment import _relative


@dataclass
class Facts:
    gps: object
    taken: object
    make: str = ""
    model: str = ""
    serial: str = ""


def photos(east, north, *, times=True):
    start = datetime(2026, 5, 1, 10, tzinfo=UTC)
    return [
        SimpleNamespace(
            name=f"{k + 1:03d}",
            metadata=Facts(
                SimpleNamespace(longitude_deg=8 + e / 71_700, latitude_deg=50 + n / 111_200),
                start + timedelta(seconds=3 * k) if times else None,
            ),
        )
        for k, (e, n) in enumerate(zip(east, north, strict=True))
    ]


def there_and_back(lines=3, photographs=5, spacing=40.0, base=15.0):
    line, k = np.divmod(np.arange(lines * photographs), photographs)
    return np.where(line % 2 == 0, k, photographs - 1 - k) * base, line * spacing


@pytest.mark.parametrize("times", [True, False])
def test_lines_end_where_the_aircraft_turns(times):
    found = flight_lines(photos(*there_and_back(), times=times))
    assert [len(set(part)) for part in np.split(found, 3)] == [1, 1, 1]
    assert len(set(found.tolist())) == 3


def test_a_turn_with_photographs_and_a_gap():
    east = np.array([0, 15, 30, 45, 60, 68, 60, 45, 30, 15, 0.0])
    north = np.array([0, 0, 0, 0, 0, 12, 24, 24, 24, 24, 24.0])
    found = flight_lines(photos(east, north))
    assert len(set(found[:5].tolist())) == len(set(found[6:].tolist())) == 1
    assert found[0] != found[7]
    gap = np.array([0, 15, 30, 45, 300, 315, 330, 345.0])
    found = flight_lines(photos(gap, 0 * gap))
    assert len(set(found[:4].tolist())) == len(set(found[4:].tolist())) == 1
    assert found[0] != found[4]


def test_photographs_without_positions_and_at_one_place():
    some = photos(*there_and_back(1, 4))
    some[1].metadata.gps = None
    assert flight_lines(some)[1] == -1
    assert set(flight_lines(photos(np.zeros(4), np.zeros(4))).tolist()) == {-1}


def test_lines_with_constants_of_their_own_fit_by_their_differences():
    camera = replace(uav_camera(), estimate=())
    block = flight_block(Flight(camera=camera, lines=3, photographs=5, points=7, size=90))
    line = np.repeat([0, 1, 2], 5)
    off = np.array([[0.5, -0.4, 0.8], [-0.6, 0.2, 0.1], [0.1, 0.7, -0.6]])[line]
    block = block.having(replace(block.stations, xyz=block.stations.xyz + off))
    shots = photos(*block.images.centre[:, :2].T)
    placed = Georeferenced(block=block, frame=None, notices=(), marked=np.zeros(len(block.points), bool), fixed=True)
    assert _relative(placed, shots, "") is placed
    found = _relative(placed, shots, "shift")
    (notice,) = found.notices
    assert (notice.code, notice.values) == ("relative_control", {"photographs": 15, "lines": 3, "drift": False})
    assert [d.values["axes"] for d in notice.details if d.code == "relative_control.open"] == [["X", "Y", "Z"]]
    result = adjust_block(found.block)
    assert result.global_test[0] < result.global_test[1] < result.global_test[2]
    lines = [r.parameters["sx"] for r in result.interior if r.camera.startswith("line")]
    apart = np.diff([p.value for p in lines])
    assert np.abs(apart - np.diff(off[::5, 0])).max() < 0.1
    assert lines[0].std > 1.0  # the place of all is that of GNSS, good to some metres
    assert not result.not_determinable  # observed with 5 m, they are known that well
    absolute = adjust_block(block)
    assert absolute.global_test[1] > 2 * absolute.global_test[2]
