"""The studio in a browser: its server as a child process, the page driven as a person would."""

import csv
import math
import os
import shutil
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

from tests.barriers import DEADLINE_S

PORTAL = Path(__file__).parents[2] / "demo_data" / "portal"
ARGUMENTS = (
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync", "--enable-unsafe-swiftshader",
)  # fmt: skip


def chromium() -> str | None:
    """Where a Chromium is: RAYBUNDLE_CHROMIUM, or the first on the path."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return os.environ.get("RAYBUNDLE_CHROMIUM") or next(filter(None, map(shutil.which, names)), None)


@contextmanager
def served(project: Path, photos: Path):
    """Address of a studio that runs as long as the block; its commands name the project without a folder."""
    command = [sys.executable, "-m", "raybundle", "studio", project.name, "--photos", str(photos), "--no-browser"]
    with subprocess.Popen(command, cwd=project.parent, stdout=subprocess.PIPE, text=True) as server:
        try:
            line = next(line for line in server.stdout if "http://" in line)
            yield line[line.index("http://") :].strip()
        finally:
            server.terminate()
            server.wait(DEADLINE_S)


def targets() -> dict[str, dict[str, tuple[float, float]]]:
    """Point -> image -> place, as measured by others."""
    found: dict[str, dict[str, tuple[float, float]]] = {}
    with (PORTAL / "measured.csv").open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            found.setdefault(row["point"], {})[row["image"]] = float(row["x_px"]), float(row["y_px"])
    return found


WHEEL, LARGEST = 0.0016, 64
"""Of the page: how much a turn of the wheel zooms, and the largest scale."""


class Hand:
    """What a person does with mouse and keys; photographs of a size [px]."""

    def __init__(self, page, size=(1600, 1200)):
        self.page = page
        self.width, self.height = size
        self.at = (0.0, 0.0)
        self.fineness = 0.0
        """A pixel of the screen, in pixels of the photograph, where it was pointed at before it was zoomed"""

    def wait(self, code, text="", seconds=DEADLINE_S):
        """Until the line below shows the words of a code, with a text in them."""
        self.page.locator(f"#message[data-code='{code}']", has_text=text).wait_for(timeout=1000 * seconds)

    def open(self, image):
        self.page.locator("#image-list [role=option]", has_text=image).click()
        self.page.locator(".pane.active .name", has_text=image).wait_for()
        self.page.locator(".pane.active .canvas:focus").wait_for()

    def point_at(self, image, x, y, zoom=8):
        """The pointer over a place of an image, zoomed in there with the wheel."""
        self.open(image)
        self.page.keyboard.press("0")
        box = self.page.locator(".pane.active .canvas").bounding_box()
        scale = 0.98 * min(box["width"] / self.width, box["height"] / self.height)
        u = box["x"] + box["width"] / 2 + (x - self.width / 2) * scale
        v = box["y"] + box["height"] / 2 + (y - self.height / 2) * scale
        self.fineness = 1 / scale
        self.page.mouse.move(u, v)
        for _ in range(zoom):
            self.page.mouse.wheel(0, -200)
        # the pointer stands on whole pixels; zoomed in, a person sees how far it is off
        grown = min(math.exp(200 * WHEEL) ** zoom, LARGEST / scale)
        u, v = (math.floor(at) + (at - math.floor(at)) * grown for at in (u, v))
        self.page.mouse.move(u + 1, v)
        self.page.mouse.move(u, v)
        self.at = u, v

    def click_here(self, name=""):
        """A click where the pointer is, until the line below shows that a point or fiducial mark is measured."""
        self.page.mouse.down()
        self.page.mouse.up()
        self.wait("studio_point.marked", name)

    def click_at(self, image, x, y):
        """Mark the current point in an image."""
        self.point_at(image, x, y)
        self.click_here()
        self.page.locator(".marks", has_text=image).wait_for()

    def new_point(self):
        self.page.keyboard.press("n")
        self.wait("studio_point.new_point")
        return self.page.locator("#point-name").input_value()

    def hair_to(self, x, y):
        """The cross hair of the pane at a place, from the middle of the photograph, with keys alone."""
        self.page.keyboard.press("0")
        self.page.keyboard.press("1")
        for value, keys in ((x - self.width / 2, "Left Right"), (y - self.height / 2, "Up Down")):
            key = "Arrow" + keys.split()[value > 0]
            steps, rest = divmod(round(abs(value)), 40)
            for _ in range(steps):
                self.page.keyboard.press(key)
            for _ in range(rest):
                self.page.keyboard.press(f"Control+{key}")

    def tab_to(self, selector, most=150):
        """Go on with the Tab key until something has the focus."""
        for _ in range(most):
            if self.page.locator(f"{selector}:focus").count():
                return
            self.page.keyboard.press("Tab")
        raise AssertionError(f"{selector} is not reached with the Tab key")
