"""What is made of a result from the page: forms, commands that the command line accepts, files, parts of pictures."""

import shlex
from io import BytesIO

import click
import numpy as np
import pytest
import rasterio
from PIL import Image

from raybundle.cli.main import cli
from raybundle.studio.products import EXPORTS, PRODUCTS

CELL, LEFT, TOP = 0.5, 100.0, 200.0


@pytest.fixture
def surface(project):
    """A surface with heights that fall to the south, unknown in one column, and an orthophoto, red in the west."""
    folder = project / "surface"
    folder.mkdir()
    z = np.repeat(np.linspace(20, 10, 40)[:, None], 60, axis=1).astype(np.float32)
    z[:, 7] = np.nan
    colours = np.zeros((4, 40, 60), np.uint8)
    colours[0, :, :30], colours[3] = 255, 255
    place = {"transform": rasterio.Affine(CELL, 0, LEFT, 0, -CELL, TOP), "width": 60, "height": 40}
    for name, values in (("heights", z[None]), ("heights_sigma", np.full((1, 40, 60), 0.02, np.float32))):
        with rasterio.open(
            folder / f"{name}.tif", "w", driver="GTiff", count=1, dtype="float32", nodata=np.nan, **place
        ) as file:
            file.write(values)
    with rasterio.open(
        folder / "orthophoto.tif", "w", driver="GTiff", count=4, dtype="uint8", photometric="RGB", alpha="YES", **place
    ) as file:
        file.write(colours)
    return folder


def part(client, path, **window):
    """Pixels of a part of a picture."""
    answer = client.get(f"/product/picture/{path}", params=window)
    assert answer.status_code == 200, answer.text
    return np.asarray(Image.open(BytesIO(answer.content)))


WHOLE = {"left": 0, "top": 0, "width": 60, "height": 40, "across": 60, "down": 40}


@pytest.mark.parametrize("name", PRODUCTS)
def test_the_command_of_a_form_is_one_of_the_command_line(client, surface, name):
    form = client.get("/api/product", params={"name": name}).json()
    assert [f["name"] for f in form["fields"]] == list(PRODUCTS[name].shown)
    command, words = cli, shlex.split(form["command"])[1:]
    context = click.Context(cli)
    while isinstance(command, click.Group):
        command = command.get_command(context, words.pop(0))
    command.make_context(name, words)  # parses all of it, runs nothing


def test_what_is_typed_stands_in_the_command(client, surface):
    values = {"outline": "'100 200, 110 200, 110 190'", "above": "12"}
    form = client.post("/api/product/settings", json={"name": "volume", "values": values}).json()
    words = shlex.split(form["command"])
    assert words[words.index("--outline") + 1] == "100 200, 110 200, 110 190"
    assert words[words.index("--above") + 1] == "12"
    assert words[-1].endswith("surface")
    refused = client.post("/api/product/settings", json={"name": "volume", "values": {"most_filled": -1}})
    assert refused.status_code == 409
    assert refused.json()["code"] == "setting.too_small"


@pytest.mark.parametrize("name", PRODUCTS)
def test_a_form_that_is_sent_back_as_it_is_changes_nothing(client, surface, name):
    form = client.get("/api/product", params={"name": name}).json()
    shown = {f["name"]: "" if f["value"] is None and f["kind"] != "number" else f["value"] for f in form["fields"]}
    again = client.post("/api/product/settings", json={"name": name, "values": shown})
    assert again.json().get("command") == form["command"], again.text


def test_exchange_files_are_made_listed_and_sent(client, studio, project):
    for name in ("exchange-1.ply", "exchange-2.ply"):
        answer = client.post("/api/product/make", json={"name": "exchange", "values": {"to": "ply"}})
        assert answer.status_code == 200, answer.text
        studio.running.wait()
        found = client.get("/api/products").json()
        assert found["run"]["outcome"] == "done", found["run"]
        (folder,) = (f for f in found["files"] if f["folder"] == EXPORTS)
        path = f"{EXPORTS}/{name}"
        assert path in [f["path"] for f in folder["files"]]
        sent = client.get(f"/product/file/{path}")
        assert sent.content == (project / path).read_bytes()
        assert "attachment" in sent.headers["content-disposition"]


def test_a_run_of_stages_is_not_that_of_a_product(client, studio):
    client.post("/api/product/make", json={"name": "exchange", "values": {"to": "ply"}})
    studio.running.wait()
    assert client.get("/api/run").json()["run"] is None
    assert client.get("/api/products").json()["run"]["name"] == "exchange"


def test_a_volume_without_heights_is_refused(client):
    answer = client.post("/api/product/make", json={"name": "volume", "values": {}})
    assert answer.status_code == 409
    assert answer.json()["code"] == "product.needs_heights"


@pytest.mark.parametrize(
    "path",
    [
        "project.db", "project.toml", "result/../project.db", "result/block/block.toml", "/etc/hosts", "",
        "surface/work/x", "surface/" + "x" * 5000, "surface/%00",
    ],
)  # fmt: skip
def test_only_listed_files_are_sent(client, surface, path):
    (surface / "work").mkdir()
    (surface / "work" / "x").write_text("kept")
    assert client.get(f"/product/file/{path}").status_code == 404


def test_links_are_not_followed(client, surface, tmp_path):
    (tmp_path / "secret.tif").write_text("secret")
    (surface / "link.tif").symlink_to(tmp_path / "secret.tif")
    assert client.get("/product/file/surface/link.tif").status_code == 404


def test_colours_of_an_orthophoto(client, surface):
    whole = part(client, "surface/orthophoto.tif", **WHOLE)
    assert whole.shape == (40, 60, 4)
    assert (whole[:, :30, 0] == 255).all()
    assert (whole[:, 30:, 0] == 0).all()
    beyond = part(client, "surface/orthophoto.tif", **(WHOLE | {"left": -60, "width": 120, "across": 120}))
    assert (beyond[:, :60, 3] == 0).all()
    assert (beyond[:, 60:, 3] == 255).all()


def test_heights_are_shaded_and_coloured(client, surface):
    whole = part(client, "surface/heights.tif", **WHOLE)
    assert (whole[:, 7, 3] == 0).all()
    assert (np.delete(whole[..., 3], 7, axis=1) == 255).all()
    assert whole[2, 30, :3].sum() > whole[-3, 30, :3].sum()  # high in the north


def test_place_of_a_picture_and_height_with_its_standard_deviation(client, surface):
    about = client.get("/api/picture", params={"file": "surface/heights.tif"}).json()
    assert about["place"] == [LEFT, TOP, CELL, CELL]
    assert about["heights"]
    at = {"file": "surface/heights.tif", "column": 20.4, "row": 0.2}
    found = client.get("/api/picture/place", params=at).json()
    assert found == {"height": pytest.approx(20), "sigma": pytest.approx(0.02)}
    assert client.get("/api/picture/place", params=at | {"file": "surface/orthophoto.tif"}).json() == found
    assert client.get("/api/picture/place", params=at | {"column": 7.5}).json()["height"] is None
    assert client.get("/api/picture/place", params=at | {"column": 70}).json() == {"height": None, "sigma": None}


@pytest.mark.parametrize(
    "window", [{"width": 0}, {"across": 0}, {"across": 100_000}, {"left": "nan"}, {"left": "x"}, {"height": 1e300}]
)
def test_impossible_parts_are_refused(client, surface, window):
    answer = client.get("/product/picture/surface/heights.tif", params=WHOLE | window)
    assert answer.status_code == 409
    assert answer.json()["code"]


def test_a_damaged_picture_is_named(client, surface):
    (surface / "orthophoto.tif").write_bytes(b"II*\0" + bytes(40))
    answer = client.get("/api/picture", params={"file": "surface/orthophoto.tif"})
    assert answer.status_code == 409
    assert answer.json()["code"] == "raster.not_readable"
