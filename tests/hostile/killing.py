"""Commands that are killed at random instants, and what they must leave: the old result or the new one, whole."""

import hashlib
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from PIL import Image

from raybundle.results.folder import PROJECT

ROOT = Path(__file__).resolve().parents[2]
PORTAL = ROOT / "demo_data/portal/photos"
TIMES = {"seconds", "cpu_seconds", "peak_memory_mb", "from_cache", "finished", "date"}
"""Keys of result.json that tell of the run, not of the result."""


@dataclass
class Job:
    """A command whose output is to be whole."""

    name: str
    command: list[str]
    """The output is named by {out}; in the place of {input} the inputs take turns."""
    inputs: list[str]
    out: Path
    continues: bool = False
    """A run that was killed is continued by the next: the end must be the same as without kills."""
    before: set[str] = field(default_factory=set)
    """What may stand beside the output"""

    def words(self, turn: int) -> list[str]:
        given = {"{out}": str(self.out), "{input}": self.inputs[turn % len(self.inputs)]}
        return [sys.executable, "-m", "raybundle", *(given.get(w, w) for w in self.command)]

    def start(self, turn: int) -> subprocess.Popen:
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "RAYBUNDLE_CAMERAS": str(self.out.parent / "library")}
        return subprocess.Popen(
            self.words(turn), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True, env=environment
        )

    def finish(self, turn: int) -> float:
        """Run to the end; seconds.  Raises AssertionError where it fails."""
        began = time.monotonic()
        running = self.start(turn)
        _, told = running.communicate(timeout=300)
        assert running.returncode == 0, told.decode()[-500:]
        return time.monotonic() - began

    def stands(self) -> dict[str, str]:
        """Names and digests of what the command wrote, without what it keeps for the next run."""
        if self.out.is_file():  # with what stands beside it
            return {p.name: _digest(p) for p in self.out.parent.glob(f"{self.out.stem}.*")}
        top = self.out / "result" if self.continues else self.out
        files = (p for p in sorted(top.rglob("*")) if p.is_file() and p.relative_to(top).parts[0] != PROJECT)
        return {str(p.relative_to(top)): _digest(p) for p in files}

    def left(self) -> list[str]:
        """Hidden files and folders in and beside the output."""
        beside = [p for p in self.out.parent.iterdir() if p.name.startswith(".")]
        inside = list(self.out.rglob(".*")) if self.out.is_dir() else []
        return [str(p.relative_to(self.out.parent)) for p in (*beside, *inside)]

    def outlives(self, running: subprocess.Popen, seconds: float) -> bool:
        """Wait until a run is to be killed; whether it still runs."""
        try:
            running.wait(seconds)
        except subprocess.TimeoutExpired:
            return True
        return False


def _digest(path: Path) -> str:
    data = path.read_bytes()
    if path.name == "result.json":
        data = json.dumps(_lasting(json.loads(data))).encode()
    if path.name == "report.html":  # it tells times
        data = b"whole" if data.rstrip().endswith(b"</html>") else b"cut off"
    return hashlib.sha256(data).hexdigest()


def _lasting(value):
    if isinstance(value, dict):
        return {k: _lasting(v) for k, v in value.items() if k not in TIMES}
    return [_lasting(v) for v in value] if isinstance(value, list) else value


@dataclass
class Outcome:
    """What kills did."""

    kills: int = 0
    survived: int = 0
    """Runs that ended before they were killed."""
    old: int = 0
    new: int = 0
    """What stood after a kill."""
    wrong: list[str] = field(default_factory=list)


def kill(job: Job, count: int, seed: int, deadline: float = float("inf")) -> Outcome:
    """Kill a command `count` times; after the deadline (of time.monotonic) no more than the first kill is waited for.

    On a busy machine the runs that show what is wanted may take all of the time: without a kill nothing would be tried.
    """
    rng = random.Random(f"{job.name} {seed}")
    told = Outcome()
    wanted = []
    for turn in range(len(job.inputs)):
        seconds = job.finish(turn)
        wanted.append(job.stands())
        if job.continues or job.out.is_file():
            _clear(job)
    turn = 0
    while told.kills < count and (time.monotonic() < deadline or told.kills == 0):
        turn += 1
        running = job.start(turn)
        late = time.monotonic() >= deadline  # a run that ends before its kill tries nothing
        if job.outlives(running, rng.uniform(0.05, 0.5 if late else 1.05) * seconds):
            os.killpg(running.pid, signal.SIGKILL)
            running.wait()
            told.kills += 1
        else:
            told.survived += 1
        if running.stderr is not None:
            running.stderr.close()
        _judge(job, wanted, told, turn)
        if (job.continues and told.kills % 4 == 0) or told.kills == count:
            _conclude(job, wanted, told, turn)
    return told


def _judge(job: Job, wanted, told: Outcome, turn: int) -> None:
    """What stands directly after a kill."""
    found = job.stands() if job.out.exists() else {}
    if job.continues:
        return  # the project may be at any stage; what comes of it is judged in the end
    if found == wanted[turn % len(wanted)]:
        told.new += 1
    elif not found or found in wanted:
        told.old += 1
    else:
        told.wrong.append(f"after kill {told.kills}: neither the old result nor the new one: {sorted(found)}")
    if job.out.is_file():
        _clear(job)


def _conclude(job: Job, wanted, told: Outcome, turn: int) -> None:
    """The next run to its end: the result as without kills, and no leftovers."""
    if not job.continues and job.out.is_file():
        _clear(job)
    job.finish(turn)
    if job.stands() != wanted[turn % len(wanted)]:
        found = job.stands()
        differ = sorted(n for n in found.keys() | wanted[turn % len(wanted)].keys()
                        if found.get(n) != wanted[turn % len(wanted)].get(n))  # fmt: skip
        told.wrong.append(f"after kill {told.kills}: the result differs in {differ}")
    if job.left():
        told.wrong.append(f"after kill {told.kills}: left {job.left()}")
    if job.continues:
        told.new += 1
        _clear(job)


def _clear(job: Job) -> None:
    if job.out.is_dir():
        shutil.rmtree(job.out)
    for path in job.out.parent.glob(f"{job.out.stem}.*"):
        path.unlink()


# --- small inputs


def orient_job(folder: Path) -> Job | None:
    """Five rendered photographs of half the size; None without them."""
    if not PORTAL.is_dir():
        return None
    photos = folder / "photos"
    photos.mkdir(parents=True)
    for k in range(1, 6):
        with Image.open(PORTAL / f"portal_{k:02d}.jpg") as image:
            image.reduce(2).save(photos / f"{k}.jpg", quality=92, exif=image.info["exif"])
    (folder / "o").mkdir()
    words = ["orient", "{input}", "--out", "{out}", "--quick", "--no-report", "--feature-count", "600", "--jobs", "2"]
    return Job("orient", words, [str(photos)], folder / "o" / "project", continues=True)


def adjust_job(folder: Path) -> Job:
    """Two blocks that are adjusted into the same folder in turns."""
    from raybundle.io.block.folder import write_block
    from tests.hostile.readers.blocks import small_block

    block = small_block().observed
    write_block(block, folder / "a")
    write_block(replace(block, name="another", sigma0_apriori=2.0), folder / "b")
    (folder / "o").mkdir()
    return Job(
        "adjust", ["adjust", "{input}", "--out", "{out}"], [str(folder / "a"), str(folder / "b")], folder / "o" / "r"
    )


def rectify_job(folder: Path) -> Job:
    """A picture to scale from one photograph and four control points."""
    rng = np.random.default_rng(1)
    folder.mkdir(parents=True, exist_ok=True)
    small = rng.integers(0, 255, (60, 80, 3), np.uint8)
    Image.fromarray(small).resize((1600, 1200)).save(folder / "a.png")
    rows = ((0, 0, 200, 1000), (4, 0, 1400, 1050), (4, 3, 1350, 150), (0, 3, 250, 200), (2, 1.5, 800, 600))
    text = "".join(f"p{k},{x},{y},\n" for k, (x, y, _, _) in enumerate(rows))
    marks = "".join(f"a.png,p{k},{u},{v}\n" for k, (_, _, u, v) in enumerate(rows))
    (folder / "c.csv").write_text("point,X,Y,Z\n" + text)
    (folder / "c-measurements.csv").write_text("image,point,x_px,y_px\n" + marks)
    (folder / "o").mkdir()
    words = ["rectify", "{input}", "--control", str(folder / "c.csv"), "--pixel", "0.002", "--out", "{out}"]
    return Job("rectify", words, [str(folder / "a.png")], folder / "o" / "picture.png")


def calibrate_job(folder: Path) -> Job:
    """Photographs of a chessboard, drawn: a pinhole of 700 px, ten places."""
    import cv2

    side, columns, rows = 40, 10, 7
    board = np.full(((rows + 2) * side, (columns + 2) * side), 255, np.uint8)
    for i in range(rows):
        for j in range(columns):
            if (i + j) % 2 == 0:
                board[(i + 1) * side : (i + 2) * side, (j + 1) * side : (j + 2) * side] = 20
    height, width = board.shape
    K = np.array([[700.0, 0, 320], [0, 700.0, 240], [0, 0, 1]])
    rng = np.random.default_rng(2)
    (folder / "photos").mkdir(parents=True)
    for k in range(10):
        turn = cv2.Rodrigues(np.array([0.5 * np.sin(2.4 * k), 0.5 * np.cos(2.4 * k), (k % 4) * np.pi / 2]))[0]
        at = np.array([0.6 * rng.uniform(-1, 1), 0.5 * rng.uniform(-1, 1), 16.0])
        scale = np.diag([1 / side, 1 / side, 1.0]) @ np.array([[1, 0, -width / 2], [0, 1, -height / 2], [0, 0, 1]])
        H = K @ np.column_stack([turn[:, 0], turn[:, 1], at]) @ scale
        picture = cv2.warpPerspective(board, H, (640, 480), flags=cv2.INTER_AREA, borderValue=128)
        noise = rng.normal(0, 2, picture.shape)
        noisy = np.clip(cv2.GaussianBlur(picture, (0, 0), 0.7) + noise, 0, 255).astype(np.uint8)
        cv2.imwrite(str(folder / "photos" / f"{k}.png"), noisy)
    (folder / "o").mkdir()
    words = ["calibrate", "{input}", "--target", f"chessboard-{columns - 1}x{rows - 1}", "--out", "{out}"]
    shutil.copytree(folder / "photos", folder / "fewer", ignore=shutil.ignore_patterns("9.png"))
    return Job("calibrate", words, [str(folder / "photos"), str(folder / "fewer")], folder / "o" / "r")


JOBS = {"orient": orient_job, "calibrate": calibrate_job, "adjust": adjust_job, "rectify": rectify_job}
