"""The server's part of masks, tables dropped on the window, and many open tabs."""

import asyncio
import json

import numpy as np
from PIL import Image

from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.measuring.journal import entries_of, journal_path
from raybundle.studio.watchers import Live
from raybundle.workflows.unoriented_block import small_pictures

TABLE = "point,X,Y,Z,sX,sY,sZ\nA,1,2,3,0.01,0.01,0.02\nB,4,5,6,0.01,0.01,0.02\n"
SQUARE = [[10, 20], [300, 20], [300, 600], [10, 600]]


def act(client, verb, key, **arguments):
    return client.post("/api/action", json={"id": key, "verb": verb, "arguments": arguments})


def test_a_dropped_table_is_one_action_and_one_undo(client, project):
    given = {"id": "drop", "text": TABLE, "file": "control.csv"}
    first, again = (client.post("/api/control", json=given).json() for _ in range(2))
    assert first["added"] == again["added"] == ["A", "B"]
    assert first["command"].endswith("mark control -- " + str(project) + " control.csv")
    assert [e.verb for e in entries_of(journal_path(project))] == ["control"]
    assert not act(client, "undo", "u").json()["state"]["points"]


def test_a_dropped_table_in_the_coordinate_system_of_the_project_is_converted(client, desk, project):
    frame = local_frame("EPSG:32632", (700_000.0, 5_400_000.0, 400.0))
    result = next(project.rglob("result.json"))
    result.write_text(json.dumps(json.loads(result.read_text()) | {"frame": frame.as_mapping()}))
    local = desk.block.images.centre[:2] + np.array([1.0, 2.0, 0.5])
    rows = [
        f"{name},{x:.6f},{y:.6f},{z:.6f}" for name, (x, y, z) in zip("AB", frame.crs_from_local(local), strict=True)
    ]
    answer = client.post("/api/control", json={"id": "utm", "text": "\n".join(["point,X,Y,Z", *rows])}).json()
    for at, point in zip(local, answer["state"]["points"], strict=True):
        np.testing.assert_allclose(point["xyz"], at, atol=1e-5)


def test_a_table_that_cannot_be_read_is_refused_with_its_line(client, project):
    answer = client.post("/api/control", json={"id": "x", "text": TABLE + "C,1,no,3,,,\n", "file": "control.csv"})
    assert answer.status_code == 409
    assert answer.json()["error"].startswith("control.csv")
    assert "table.csv" not in answer.json()["error"]
    assert not entries_of(journal_path(project))


def test_a_mark_far_from_the_prediction_is_red_at_once(client, desk):
    """Of a point of the block: the answer to the action states it, and so does the prediction, which draws it."""
    o = desk.block.observations
    point = int(np.argmax(desk.block.ray_count))
    row = np.flatnonzero(o.point == point)[0]
    name, image = desk.block.points.ids[point], desk.block.images.ids[o.image[row]]
    x, y = map(float, o.xy_px[row])
    cov = [0.25, 0.25, 0.0]
    good = act(client, "put", "p1", point=name, image=image, x_px=x + 0.2, y_px=y, covariance=cov).json()
    assert not good["test"]["off"]
    bad = act(client, "move", "p2", point=name, image=image, x_px=x + 30, y_px=y, covariance=cov).json()
    assert bad["test"]["off"]
    found = client.get("/api/predict", params={"point": name, "images": [image]}).json()
    assert image in found["off"]
    assert act(client, "undo", "p3").json()["test"] is None
    assert client.get("/api/predict", params={"point": name, "images": [image]}).json()["off"] == []


def test_masks_are_told_of_each_image(client, desk):
    a, b = desk.given.images.ids[:2]
    done = act(client, "mask", "m1", mask="tree", image=a, polygon=SQUARE)
    assert done.status_code == 200
    assert "--polygon '10,20 300,20" in done.json()["command"]
    assert act(client, "mask", "m2", mask="bonnet", image=a, polygon=SQUARE, camera=True).status_code == 200
    areas = {i: [x["mask"] for x in client.get("/api/masks", params={"image": i}).json()["areas"]] for i in (a, b)}
    assert areas == {a: ["tree", "bonnet"], b: ["bonnet"]}
    assert act(client, "unmask", "m3", mask="tree").json()["state"]["masks"][0]["mask"] == "bonnet"
    refused = act(client, "mask", "m4", mask="sky", image=a, polygon=SQUARE[:2])
    assert refused.status_code == 409
    assert refused.json()["code"] == "mark.mask_corners"


def test_masks_read_from_a_folder_are_shown(client, desk, project, tmp_path):
    image = desk.given.images.ids[0]
    assert client.get("/api/mask", params={"image": image}).status_code == 204
    free = np.full((1200, 1600), 255, np.uint8)
    free[:600] = 0
    (tmp_path / "given").mkdir()
    Image.fromarray(free).save(tmp_path / "given" / f"{desk.given.images.file[0]}.png")
    text = (project / "project.toml").read_text()
    (project / "project.toml").write_text(text.replace("[orient]", f'[orient]\nmasks = "{tmp_path / "given"}"'))
    assert client.get("/api/overview").json()["masks_given"] == str(tmp_path / "given")
    answer = client.get("/api/mask", params={"image": image})
    (tmp_path / "shown.png").write_bytes(answer.content)
    with Image.open(tmp_path / "shown.png") as opened:
        alpha = np.asarray(opened)[:, :, 3]
    assert alpha.mean() == 127.5


def test_orient_again_heeds_what_was_drawn(project):
    """The project's own masks are taken without being named, and the journal's name of them is not kept as given."""
    import raybundle as rb
    from raybundle.commands.drawn_masks import masks_of_run

    photos = tuple(sorted((project.parent / "photos").glob("*.jpg"))[:5])
    taken = (photos, None, project)
    assert masks_of_run(*taken) is None
    rb.mark(project, "mask", mask="top", image=photos[0].name, polygon=SQUARE, camera=True)
    assert masks_of_run(*taken) == project / "measured-masks"
    assert len([*(project / "measured-masks").glob("*.png")]) == 5
    rb.mark(project, "undo")
    assert masks_of_run(*taken) is None


def test_three_hundred_tabs_are_told_at_once():
    """A state of 5000 marks is written down once, not once a tab."""

    async def told():
        live = Live()
        queues = [live.join() for _ in range(300)]
        message = {"type": "state", "state": {"marks": [{"image": "a", "point": str(k)} for k in range(5000)]}}
        live.notify(message)
        return [q.get_nowait() for q in queues]

    texts = asyncio.run(told())
    assert len(texts) == 300
    assert all(t is texts[0] for t in texts)


def test_a_picture_of_a_pixel_is_remarked():
    (line,) = small_pictures({"a.jpg": (1, 1), "b.jpg": (4000, 3000)})
    assert line.startswith("a.jpg ")
    assert "1 x 1" in line
