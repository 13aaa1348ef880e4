"""The studio's object space with a million points: what is sent, how long it takes, and the pictures that follow.

    python benchmarks/studio_space.py [POINTS]

A flight over a hilly ground: every point in the photographs whose stations are nearest, exact but for 0.3 px.  The page
is opened in Chromium, which draws with the processor (SwiftShader).  Figures go to standard output and to
benchmarks/results/studio_space.json.  Needs playwright and a Chromium (RAYBUNDLE_CHROMIUM names one).
"""

from __future__ import annotations

import argparse
import json
import queue
import sys
import tempfile
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))
from benchmarks.run import machine  # noqa: E402
from tests.studio.browser import ARGUMENTS, chromium  # noqa: E402

from raybundle.block import Block, Images, Observations, Points  # noqa: E402
from raybundle.planning.simulate import project  # noqa: E402
from raybundle.planning.synthetic_networks import Scene, brown_camera  # noqa: E402
from raybundle.studio.desk import Desk  # noqa: E402
from raybundle.studio.scene import scene as scene_of  # noqa: E402

SIZE = (1366, 768)
RAYS, SPACING = 4, 25.0
TURNS = 40
"""Pictures of a motion that are timed."""


def block_of(points: int, stations: int = 20, rays: int = RAYS, spacing: float = SPACING) -> Block:
    """A square flight with so many object points."""
    rng = np.random.default_rng(4)
    side = spacing * stations
    xyz = np.column_stack([rng.uniform(0, side, (points, 2)), np.zeros(points)])
    xyz[:, 2] = 8 * np.sin(xyz[:, 0] / 40) * np.cos(xyz[:, 1] / 55) + rng.gamma(1, 0.5, points)
    at = (np.arange(stations) + 0.5) * spacing
    centre = np.column_stack([*(g.ravel() for g in np.meshgrid(at, at)), np.full(stations**2, 60.0)])
    rotation = np.tile(np.eye(3), (len(centre), 1, 1))
    camera = brown_camera()
    nearest = cKDTree(centre[:, :2]).query(xyz[:, :2], rays)[1]
    image, point, xy = [], [], []
    for i in range(len(centre)):
        near = np.flatnonzero((nearest == i).any(axis=1))
        seen, places = project(Scene(camera=camera, centre=centre, rotation=rotation, xyz=xyz[near]), i)
        image.append(np.full(len(seen), i))
        point.append(near[seen])
        xy.append(places)
    m = sum(map(len, image))
    return Block(
        name="flight", cameras=(camera,),
        images=Images(ids=tuple(f"I{k}" for k in range(len(centre))), camera=np.zeros(len(centre), np.int32),
                      file=("",) * len(centre), centre=centre, rotation=rotation, interior={}),
        observations=Observations(
            image=np.concatenate(image).astype(np.int32), point=np.concatenate(point).astype(np.int32),
            xy_px=np.concatenate(xy) + 0.3 * rng.standard_normal((m, 2)), cov_px2=np.tile([0.09, 0.09, 0.0], (m, 1)),
        ),
        points=Points(ids=tuple(f"t{k}" for k in range(points)), role=np.zeros(points, np.int32), xyz=xyz,
                      sigma=np.full((points, 3), np.nan)),
    )  # fmt: skip


def seconds(what, count=3):
    """Median time of some calls, and what the last one gave."""
    times, found = [], None
    for _ in range(count):
        began = time.perf_counter()
        found = what()
        times.append(time.perf_counter() - began)
    return round(float(np.median(times)), 3), found


PICTURES = """async (count) => {
  const canvas = document.querySelector("#space canvas");
  const gl = canvas.getContext("webgl2");
  const pixel = new Uint8Array(4);
  const picture = () => new Promise((done) => requestAnimationFrame(() => {
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    done(performance.now());
  }));
  const left = { key: "ArrowLeft", bubbles: true, cancelable: true };
  const turn = () => canvas.dispatchEvent(new KeyboardEvent("keydown", left));
  const found = [];
  for (let k = 0; k < count; k++) {
    const began = performance.now();
    turn();
    found.push((await picture()) - began);
  }
  return found;
}"""
HOVER = """() => {
  const canvas = document.querySelector("#space canvas");
  const box = canvas.getBoundingClientRect();
  const found = [];
  return new Promise((done) => {
    const step = (k) => {
      if (k === 20) return done(found);
      const began = performance.now();
      const at = { clientX: box.left + 300 + 9 * k, clientY: box.top + 250, bubbles: true };
      canvas.dispatchEvent(new PointerEvent("pointermove", at));
      requestAnimationFrame(() => { found.push(performance.now() - began); step(k + 1); });
    };
    step(0);
  });
}"""


def in_page(address: str) -> dict:
    """What a person waits for."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium(), args=list(ARGUMENTS))
        page = browser.new_page(viewport={"width": SIZE[0], "height": SIZE[1]})
        page.set_default_timeout(300_000)
        page.goto(address)
        page.locator("#image-list [role=option]").first.wait_for()
        began = time.perf_counter()
        page.click("#tab-space")
        page.locator("#space-legend li").first.wait_for()
        page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
        shown = time.perf_counter() - began
        transfer = page.evaluate(
            "() => { const e = performance.getEntriesByName(location.origin + '/api/scene')[0];"
            " return { bytes: e.encodedBodySize, wait_ms: e.responseStart - e.requestStart,"
            " transfer_ms: e.responseEnd - e.responseStart }; }"
        )
        page.wait_for_timeout(1500)
        times = page.evaluate(PICTURES, TURNS)
        page.wait_for_timeout(1000)
        hover = page.evaluate(HOVER)
        colour = {}
        for by in ("rays", "sigma"):
            colour[by] = page.evaluate(
                "(by) => { const s = document.querySelector('#space-colour'); s.value = by;"
                " const t = performance.now(); s.dispatchEvent(new Event('change'));"
                " return performance.now() - t; }", by,
            )  # fmt: skip
        chosen = chosen_in(page)
        browser.close()
    return {
        "space_shown_s": round(shown, 2), **{k: round(v) for k, v in transfer.items()},
        "whole_picture_ms": round(times[0]), "motion_ms_median": round(float(np.median(times[TURNS // 2 :]))),
        "motion_ms_all": [round(t) for t in times],
        "hover_ms_median": round(float(np.median(hover)), 1),
        "colour_ms": {k: round(v) for k, v in colour.items()}, **chosen,
    }  # fmt: skip


def chosen_in(page) -> dict:
    """A click on a point that the pointer has found: until its name stands in the panel."""
    page.uncheck("#show-stations")
    box = page.locator("#space canvas").bounding_box()
    for k in range(60):
        at = box["x"] + box["width"] * (0.3 + 0.006 * k), box["y"] + box["height"] * 0.5
        page.mouse.move(*at)
        page.wait_for_timeout(120)
        if page.locator("#space .tip").is_visible():
            began = time.perf_counter()
            page.mouse.click(*at)
            while not page.locator("#point-name").input_value() and time.perf_counter() - began < 10:
                page.wait_for_timeout(2)
            return {"click_ms": round(1000 * (time.perf_counter() - began))}
    return {"click_ms": None}


def main() -> None:
    """Figures of one block."""
    parser = argparse.ArgumentParser()
    parser.add_argument("points", type=int, nargs="?", default=1_000_000)
    points = parser.parse_args().points
    import raybundle as rb

    with tempfile.TemporaryDirectory() as folder:
        block = block_of(points)
        rb.write_block(block, Path(folder) / "flight")
        tiles = Path(folder) / "tiles"
        tiles.mkdir()
        opened, desk = seconds(lambda: Desk.open(Path(folder) / "flight", tiles), 1)
        graph, found = seconds(lambda: desk.shared, 1)
        made, body = seconds(lambda: scene_of(desk))
        desk.close()
        told = {
            "points": points, "images": len(block.images), "observations": len(block.observations),
            "open_s": opened, "scene_s": made, "scene_bytes": len(body), "graph_s": graph, "pairs": len(found),
        }  # fmt: skip
        with server(Path(folder) / "flight") as address:
            told["page"] = in_page(address)
    told["machine"] = machine()
    print(json.dumps(told, indent=1))
    if points == 1_000_000:
        (ROOT / "benchmarks/results/studio_space.json").write_text(json.dumps(told, indent=1) + "\n")


@contextmanager
def server(folder: Path):
    """Address of a studio that looks only: what would adjust waits, so that nothing else has the processor."""
    from raybundle.studio.serve import serve
    from raybundle.studio.work import Work

    begin, Work.begin = Work.begin, lambda *_, **__: False
    addresses: queue.Queue[str] = queue.Queue()
    # it ends with the program: its signals are not for this thread
    threading.Thread(
        target=serve, args=(folder,), kwargs={"browser": False, "notify": addresses.put}, daemon=True
    ).start()
    try:
        yield addresses.get(timeout=300)
    finally:
        Work.begin = begin


if __name__ == "__main__":
    main()
