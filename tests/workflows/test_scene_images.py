"""Which files are scenes, which are photographs, and which are refused with a reason; pixels read by tiles."""

import numpy as np
import pytest
from PIL import Image, TiffImagePlugin, TiffTags

from raybundle.errors import InputError, code_of, phrase
from raybundle.io.photos.photo import find_photos
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.matching.methods import feature_method
from raybundle.matching.refine import halved
from raybundle.workflows.scenes import block as scene_block
from raybundle.workflows.scenes import images as scene_images
from raybundle.workflows.scenes.images import ScenePixels, find_scenes, scene_features
from tests.scenes.render import octave, scene_rpc, write_scene

SIZE = 400
RNG = np.random.default_rng(6)
PIXELS = np.clip(500 + 150 * (octave(RNG, SIZE, 30) + octave(RNG, SIZE, 8)), 1, 2047).astype(np.uint16)


def rpc():
    return scene_rpc(0.2, 1100)


@pytest.fixture
def folder(tmp_path):
    path = tmp_path / "files"
    path.mkdir()
    return path


def test_scenes_are_told_from_photographs(folder):
    write_scene(folder, "tagged", PIXELS, rpc(), tag=True)
    write_scene(folder, "beside", PIXELS + 1, rpc())
    Image.fromarray(PIXELS + 2).save(folder / "rpb.tif")
    write_rpc_text(rpc(), folder / "rpb.RPB")
    Image.fromarray(PIXELS + 3).save(folder / "plain.tif")
    Image.fromarray((PIXELS >> 3).astype(np.uint8)).save(folder / "photo.jpg")
    (folder / "photo.xml").write_text("<document version='2.0'><chunk/></document>")
    found = find_scenes([folder])
    assert [s.name for s in found.scenes] == ["beside.tif", "rpb.tif", "tagged.tif"]
    assert [s.model.name for s in found.scenes] == ["beside_RPC.TXT", "rpb.RPB", "tagged.tif"]
    assert found.refused == ()
    assert len({s.geometry_key for s in found.scenes}) == 2  # the two texts are equal
    photos = find_photos([folder], leave=found.files)
    assert [p.name for p in photos.photos] == ["photo.jpg", "plain.tif"]
    assert not [r for r in photos.remarks if ".txt" in r]


def test_what_cannot_be_used_costs_that_file(folder):
    good = write_scene(folder, "good", PIXELS, rpc())
    (folder / "again.tif").write_bytes(good.read_bytes())
    write_rpc_text(rpc(), folder / "again_RPC.TXT")
    write_scene(folder, "broken", PIXELS, rpc())
    text = (folder / "broken_RPC.TXT").read_text()
    (folder / "broken_RPC.TXT").write_text(text.replace("LINE_NUM_COEFF_7", "LINE_NUM_COEFF_77"))
    Image.fromarray(PIXELS.astype(np.float32)).save(folder / "float.tif")
    write_rpc_text(rpc(), folder / "float_RPC.TXT")
    (folder / "vendor.ntf").write_bytes(b"NITF02.10" + bytes(500))
    found = find_scenes([folder])
    assert [s.name for s in found.scenes] == ["again.tif"]
    refused = dict(found.refused)
    assert set(refused) == {"good.tif", "broken.tif", "float.tif", "vendor.ntf"}
    assert refused["good.tif"] == phrase("photograph.copy", original="again.tif")
    assert "coefficients" in refused["broken.tif"]
    assert (code_of(refused["float.tif"]), refused["float.tif"].message.values["bits"]) == ("tiff.pixel_format", [32])
    vendor = refused["vendor.ntf"].message.values
    assert (vendor["source"], vendor["target"]) == ("vendor.ntf", "vendor.tif")


def test_maps_and_their_files_are_no_photographs(folder):
    geotiff = {33550: (10.0, 10.0, 0.0), 33922: (0.0, 0.0, 0.0, 5e5, 5.3e6, 0.0)}
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    for tag, values in geotiff.items():
        tags.tagtype[tag] = TiffTags.DOUBLE
        tags[tag] = values
    Image.fromarray(PIXELS).save(folder / "LC09_B4.TIF", tiffinfo=tags)
    (folder / "LC09_MTL.txt").write_text("GROUP = LANDSAT_METADATA_FILE\n")
    (folder / "notes.txt").write_text("two photographs")
    Image.fromarray((PIXELS >> 3).astype(np.uint8)).save(folder / "photo.jpg")
    found = find_scenes([folder])
    assert {name: code_of(reason) for name, reason in found.refused} == {
        "LC09_B4.TIF": "scene.is_map", "LC09_MTL.txt": "scene.is_map",
    }  # fmt: skip
    assert [p.name for p in find_photos([folder], leave=found.files).photos] == ["photo.jpg"]


def test_an_image_of_another_size_than_its_file_says(folder, monkeypatch):
    path = write_scene(folder, "one", PIXELS, rpc())
    scene = scene_images.read_scene(folder / "one_RPC.TXT")
    other = type(scene)(file=scene.file, format="x", rpc=scene.rpc, width_px=500, height_px=SIZE)
    monkeypatch.setattr(scene_images, "read_scene", lambda _: other)
    of_image, of_file = {"width_px": 400, "height_px": 400}, {"model_width_px": 500, "model_height_px": 400}
    other_size = phrase("scene.other_size", model="one_RPC.TXT", **of_image, **of_file)
    assert find_scenes([path]).refused == (("one.tif", other_size),)


def test_tiles_give_what_the_whole_gives(folder, monkeypatch):
    write_scene(folder, "one", PIXELS, rpc())
    (scene,) = find_scenes([folder]).scenes
    pixels = ScenePixels(scene)
    whole, tiled = np.zeros((SIZE, SIZE), np.uint16), np.zeros((SIZE, SIZE), np.uint16)
    pixels.smooth(whole)
    alone = scene_features(feature_method("rootsift"), scene, 300)
    monkeypatch.setattr(scene_images, "TILE_PX", 150)
    monkeypatch.setattr(scene_images, "MARGIN_PX", 60)
    pixels.smooth(tiled)
    np.testing.assert_array_equal(whole, tiled)
    parts = scene_features(feature_method("rootsift"), scene, 300)
    assert 150 < len(parts) <= 400
    assert (parts.xy_px.max(axis=0) > 300).all()
    near = np.linalg.norm(parts.xy_px[:, None] - alone.xy_px[None], axis=2).min(axis=1)
    assert (near < 0.3).mean() > 0.5


def test_the_border_of_an_empty_part_is_no_texture(folder):
    empty = PIXELS.copy()
    empty[np.add.outer(np.arange(SIZE), np.arange(SIZE)) < 350] = 0
    write_scene(folder, "corner", empty, rpc())
    (scene,) = find_scenes([folder]).scenes
    found = scene_features(feature_method("rootsift"), scene, 400)
    assert len(found) > 50
    assert (found.xy_px.sum(axis=1) > 350).all()


def test_an_image_without_values_is_refused(folder):
    write_scene(folder, "black", np.zeros((SIZE, SIZE), np.uint16), rpc())
    (scene,) = find_scenes([folder]).scenes
    with pytest.raises(InputError, match=r"0.*scene\.all_zero"):
        ScenePixels(scene)


def test_a_level_made_in_strips_is_that_of_the_whole(tmp_path, monkeypatch):
    fine = np.random.default_rng(4).integers(0, 60000, (301, 203)).astype(np.uint16)
    monkeypatch.setattr(scene_block, "STRIP", 40)
    found = scene_block._halved_file(fine, tmp_path / "level")
    np.testing.assert_array_equal(found, halved(fine))
