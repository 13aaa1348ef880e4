"""A part of a surface, and photographs of which a part is masked: three of the portal, at half their size."""

import json
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from pyproj import CRS, Transformer

from raybundle.commands.surface import surface
from raybundle.errors import InputError, code_of, phrase
from raybundle.numerics.progress import silent
from raybundle.pipeline.store import Folder
from raybundle.surfaces.depths.depth_map import DepthMap
from raybundle.surfaces.depths.rays import ReferenceRays
from raybundle.surfaces.depths.refine import Reason
from raybundle.surfaces.grid import HeightPlane
from raybundle.surfaces.region import SurfaceRegion
from raybundle.surfaces.region_input import region_asked
from raybundle.surfaces.stages.fusion import CONFIRMED
from raybundle.surfaces.stages.sources import STAGE, choose
from raybundle.surfaces.state import SurfaceOptions, SurfaceState
from raybundle.surfaces.tiles import tile_of_number
from raybundle.surfaces.without_points import pointless
from tests.messages import coded, refused

BOX = (-0.6, -0.4, 0.5, 0.5)


@pytest.fixture(scope="module")
def whole(half, copy_of_surface, tmp_path_factory):
    out = copy_of_surface(tmp_path_factory.mktemp("whole") / "s")
    return surface(half / "block", out, photos=(half,), density="4", jobs=1)


@pytest.fixture(scope="module")
def part(half, tmp_path_factory):
    out = tmp_path_factory.mktemp("part") / "s"
    return surface(half / "block", out, photos=(half,), density="4", jobs=1, extent=BOX)


def maps_of(done):
    return {i: DepthMap.of_arrays(done.surface.store.wanted(key)).sure() for i, key in done.surface.maps.items()}


def region_of(done):
    return done.surface.options.region


def test_points_of_a_part_are_those_of_the_whole_there(whole, part):
    """Within standard deviations: pixel by pixel of the maps, and nearly as many of them in the cloud.

    The roughness of a place at the rim of a part is known from fewer surroundings: 6 % fewer points are confirmed.
    """
    region, block = region_of(part), whole.surface.block
    before, after = maps_of(whole), maps_of(part)
    known = lost = new = 0
    moved, sigmas = [], []
    for k, m in after.items():
        inside = np.zeros(m.t.shape, bool)
        rays, there = ReferenceRays.of(block, k), np.isfinite(m.t)
        inside[there] = region.holds(m.points(block, k))
        b, g = before[k], before[k].grid
        row, column = (m.grid.y0 - g.y0) // 4, (m.grid.x0 - g.x0) // 4
        of_whole = [a[row : row + m.grid.rows, column : column + m.grid.columns] for a in (b.t, b.noise + b.roughness)]
        both = inside & np.isfinite(of_whole[0])
        known, new = known + int(both.sum()), new + int((inside & ~both).sum())
        points, had = b.points(block, k), np.isfinite(b.t)
        of_region = np.zeros(had.shape, bool)
        of_region[had] = region.holds(points)
        lost += int(of_region.sum()) - int(both.sum())
        sigma = np.sqrt(of_whole[1][both])
        moved.append(np.abs(m.t[both] - of_whole[0][both]) / sigma)
        sigmas.append(np.sqrt((m.noise + m.roughness)[both]) / sigma)
        assert rays.camera.width_px > m.grid.columns
    moved, sigmas = np.concatenate(moved), np.concatenate(sigmas)
    assert known > 1000
    # those on the brink of a test against their neighbours
    assert max(new, lost) < 0.1 * known
    assert np.median(moved) < 0.02
    assert np.quantile(moved, 0.97) < 1
    assert np.median(sigmas) == pytest.approx(1, abs=0.1)
    inside = sum(int(region.holds(c.xyz).sum()) for c in whole.surface.parts())
    assert len(part.surface) == pytest.approx(inside, rel=0.08)
    for c in part.surface.parts():
        assert region.holds(c.xyz).all()


def test_what_lies_around_a_part_costs_nothing(whole, part):
    pixels, all_pixels = (sum(m.t.size for m in maps_of(d).values()) for d in (part, whole))
    tried = sum(int((m.reason != Reason.NO_START).sum()) for m in maps_of(part).values())
    assert pixels < 0.7 * all_pixels
    assert tried < pixels


def test_photographs_that_show_nothing_of_a_part_are_left_out_and_told(part):
    block, plane = part.surface.block, region_of(part).plane

    def chosen(u):
        slab = SurfaceRegion.of(plane, [[np.array([[u, -3.0], [u + 0.1, -3], [u + 0.1, 3], [u, 3]])]])
        state = SurfaceState(
            adjustment=part.surface.adjustment, photos=dict.fromkeys(range(3)), options=SurfaceOptions(region=slab)
        )  # fmt: skip
        try:
            return slab, STAGE.put(state, choose(STAGE.inputs(state), SimpleNamespace(progress=silent)))
        except InputError:
            return slab, None

    slab, state = next((r, s) for r, s in map(chosen, np.arange(-4.0, 4.0, 0.1)) if s and 0 < len(s.chosen) < 3)
    told = {name for name, why in state.left_out if why == phrase("depths.region_not_shown")}
    assert told == {block.images.ids[k] for k in {0, 1, 2} - {s.reference for s in state.chosen}}
    assert all(0 < state.shares[s.reference] < 0.5 for s in state.chosen)
    # what is left out has none of the tie points in the region, what is not shows some or looks past it
    o = block.observations
    there = slab.holds(block.points.xyz)[o.point]
    for k in {0, 1, 2} - {s.reference for s in state.chosen}:
        assert not (there & (o.image == k)).any()


def test_a_part_is_an_outline_a_file_or_a_rectangle(half, tmp_path):
    def ask(**given):
        return surface(half / "block", tmp_path / "s", photos=(half,), density="4", **given)

    with pytest.raises(InputError, match=r"region=.*extent=.*option\.exclusive"):
        ask(region=("0 0, 1 0, 1 1",), extent=BOX)
    with pytest.raises(InputError, match=r"surface\.region_invalid") as error:
        ask(region=("0 0, 1 1, 1 0, 0 1",))
    assert [d.code for d in error.value.message.details] == ["flight_area.crosses_itself"]
    with pytest.raises(InputError, match=r"1.*0.*outline\.extent_empty"):
        ask(extent=(1.0, 0.0, 0.0, 1.0))
    with pytest.raises(InputError, match=r"100.*101.*surface\.region_not_shown"):
        ask(extent=(100.0, 0.0, 101.0, 1.0))
    (tmp_path / "l.csv").write_text("0,0\n1,0\n")
    with pytest.raises(InputError, match=r"surface\.region_invalid") as error:
        ask(region=(str(tmp_path / "l.csv"),))
    assert [d.code for d in error.value.message.details] == ["flight_area.too_few_corners"]
    assert not (tmp_path / "s").exists()


def test_rays_that_pass_an_area_are_told_however_long_they_are():
    plane = HeightPlane(origin=(0.0, 0.0, 0.0), axes=((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)))
    square = np.array([[0.0, 0], [4, 0], [4, 4], [0, 4]])
    region = SurfaceRegion.of(plane, [[square, square / 4 + 1.5]])  # with a hole from 1.5 to 2.5
    assert region.extent.tolist() == [0, 0, 4, 4]
    assert region.holds(np.array([[1.0, 1, 9], [2, 2, 9], [5, 1, 0]])).tolist() == [True, False, False]
    one = np.array([[-1.0, 1, 5], [-1, 5, 5], [1.9, 1.9, 5], [-3, 2, 0], [1, 1, 3]])
    other = np.array([[9.0, 2, 0], [9, 6, 0], [2.1, 2.1, 0], [-1, 2, 0], [1.1, 1, 0]])
    assert region.meets(one, other).tolist() == [True, False, False, False, True]


@pytest.mark.long
def test_nothing_is_measured_where_a_mask_is_black_nor_by_what_it_hides(half, whole, tmp_path):
    pytest.importorskip("rasterio")
    masks = tmp_path / "masks"
    masks.mkdir()
    block = whole.surface.block
    names = block.images.file
    height, width = cv2.imread(str(half / names[0])).shape[:2]
    free = np.full((height, width), 255, np.uint8)
    free[height // 4 : height // 2, width // 4 : width // 2] = 0
    cv2.imwrite(str(masks / f"{names[0]}.png"), free)
    done = surface(half / "block", tmp_path / "s", photos=(half,), density="4", jobs=1, masks=masks, ortho=0.05)
    (stated,) = (r.message.values for r in done.remarks if code_of(r) == "masks")
    assert {"n": 1, "photographs": 3, "of": "depths"}.items() <= stated.items()
    from raybundle.adjustment.system.predict import predicted_px

    before, after = maps_of(whole), maps_of(done)
    m = after[0]
    x, y = np.floor(m.grid.xy_px).astype(int).reshape(-1, 2).T
    hidden = free[y, x].reshape(m.t.shape) == 0
    assert np.isfinite(before[0].t[hidden]).mean() > 0.3
    reach = cv2.dilate((free == 0).astype(np.uint8), np.ones((7, 7), np.uint8))[y, x].reshape(m.t.shape) > 0
    assert not np.isfinite(m.t[reach]).any()
    assert np.isfinite(m.t[~reach]).mean() == pytest.approx(np.isfinite(before[0].t[~reach]).mean(), abs=0.03)
    # as a source it tells nothing there either
    for k, found in after.items():
        if k == 0:
            continue
        s = found.sources.index(0)
        known = np.isfinite(found.t)
        used = (found.views[known] >> s) & 1 == 1
        there = np.floor(predicted_px(block, 0, found.points(block, k))).astype(int)
        inside = ((there >= 0) & (there < [width, height])).all(axis=1)
        masked = np.zeros(len(there), bool)
        masked[inside] = free[there[inside, 1], there[inside, 0]] == 0
        assert masked.sum() > 50
        assert not (used & masked).any()
        assert used[inside & ~masked].mean() > 0.5
    # nor does an orthophoto take its colours there
    grid, taken = done.surface.heights.grid, 0
    for tile, key in done.surface.orthophoto.choice.items():
        row, column = np.nonzero(done.surface.store.wanted(key)["image"] == 0)
        height = done.surface.store.wanted(done.surface.heights.tiles[tile])["height"][row, column]
        row, column, height = (a[np.isfinite(height)] for a in (row, column, height))  # not those that were filled
        w = tile_of_number(grid, tile)
        there = np.floor(predicted_px(block, 0, grid.points_at(w.x + column + 0.5, w.y + row + 0.5, height))).astype(
            int
        )
        assert (free[there[:, 1], there[:, 0]] > 0).all()
        taken += len(row)
    assert taken > 50
    with refused("file.missing", file="none"):
        surface(half / "block", tmp_path / "t", photos=(half,), density="4", masks=tmp_path / "none")


def test_it_is_told_why_a_photograph_gives_no_point(part, tmp_path):
    """From what the fusion kept beside its points; not where other maps know its places better."""
    done, store = part.surface, Folder(tmp_path)
    names, kept = done.block.images.ids, done.store.wanted(dict(done.clouds)[0], ("depths", "share"))
    assert kept["depths"] >= done.counts[0] > 0
    assert CONFIRMED <= kept["share"] <= 1
    given = {0: (900, 0.0, 0), 1: (0, 0.0, 0), 2: (900, 0.31, 0), 3: (900, 0.9, 0), 4: (900, 0.2, 5)}
    for k, (depths, share, points) in given.items():
        store.store(str(k), {"depths": np.array(depths), "share": np.array(share), "image": np.zeros(points)})
    keys = {k: str(k) for k in given}
    reasons = {name: coded([why]) for name, why in pointless(done.block, keys, store, region=True)}
    assert reasons == {
        names[0]: {"surface_remark.too_few_confirmed": {"share": 0.0, "needed": CONFIRMED}},
        names[1]: {"surface_remark.no_depth": {"region": True}},
        names[2]: {"surface_remark.too_few_confirmed": {"share": 0.31, "needed": CONFIRMED}},
    }
    whole = dict(pointless(done.block, keys, store))[names[1]]
    assert coded([whole]) == {"surface_remark.no_depth": {"region": False}}


def test_an_outline_in_another_system_is_brought_into_that_of_the_map(tmp_path):
    """And refused where there is a plane of the object in place of a map."""
    ring = np.array([[500000.0, 5300000.0], [500100.0, 5300000.0], [500100.0, 5300100.0]])
    east, north = Transformer.from_crs(32633, 25832, always_xy=True).transform(*ring.T)
    corners = [[e, n] for e, n in zip(east.tolist(), north.tolist(), strict=True)]
    shape = {"type": "Polygon", "coordinates": [[*corners, corners[0]]]}
    system = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}
    file = tmp_path / "plan.geojson"
    feature = {"type": "Feature", "properties": {}, "geometry": shape}
    file.write_text(json.dumps({"type": "FeatureCollection", "crs": system, "features": [feature]}))
    plane = HeightPlane(origin=(0.0, 0.0, 0.0), axes=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    found = region_asked(plane, CRS.from_epsg(32633).to_wkt(), [str(file)], None, 1.0)
    np.testing.assert_allclose(found.areas[0][0], ring, rtol=0, atol=1e-6)
    with pytest.raises(InputError, match=r"plan\.geojson.*EPSG.*25832.*outline\.heights_in_no_map"):
        region_asked(plane, "", [str(file)], None, 1.0)
