"""map.csv: adjusted coordinates in the system of the control, with standard deviations in that system."""

import numpy as np

from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.report.write import write_result
from raybundle.results.map_table import map_table


def test_coordinates_go_there_and_back_and_sigmas_are_scaled(free_case):
    frame = local_frame("EPSG:32632", (500_000.0, 5_300_000.0, 400.0))
    table, _ = map_table(free_case, frame)
    there = np.stack([table[k] for k in "XYZ"], axis=1)
    images = np.array([k == "image" for k in table["kind"]])
    taken = free_case.adjusted.images.oriented
    np.testing.assert_allclose(frame.local_from_crs(there[images]), free_case.adjusted.images.centre[taken], atol=1e-6)
    ids = {name: k for k, name in enumerate(free_case.adjusted.points.ids)}
    rows = [ids[i] for i, image in zip(table["id"], images, strict=True) if not image]
    np.testing.assert_allclose(frame.local_from_crs(there[~images]), free_case.adjusted.points.xyz[rows], atol=1e-6)
    # on the central meridian of UTM lengths are shortened by 4 in 10 000, heights are not
    ratio = table["sX"][~images] / np.sqrt(free_case.precision.object_points[rows, 0, 0])
    np.testing.assert_allclose(ratio, 0.9996 * (1 - 400 / 6.38e6), rtol=2e-5)


def test_the_result_folder_holds_it(free_case, tmp_path):
    frame = local_frame("EPSG:32632", (500_000.0, 5_300_000.0, 400.0))
    write_result(free_case, tmp_path / "r", report="none", frame=frame)
    lines = (tmp_path / "r/map.csv").read_text().splitlines()
    assert lines[0] == "kind,id,X,Y,Z,sX,sY,sZ"
    assert len(lines) == 1 + len(map_table(free_case, frame)[0]["id"])
    # written over without complaint
    write_result(free_case, tmp_path / "r", report="none")
    assert not (tmp_path / "r/map.csv").exists()
