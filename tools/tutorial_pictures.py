"""Pictures of the tutorials for the documentation: what their commands make, in small.

    python tools/tutorial_pictures.py

Runs the commands of docs/tutorial/a-flight.md, measure-a-part.md and a-facade.md as they stand there, makes the set
board, and writes docs/images/report.png and docs/images/tutorial-*.  Needs pdftoppm (poppler).
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

from raybundle.commands.demonstrations import make_set

ROOT = Path(__file__).resolve().parents[1]
IMAGES = ROOT / "docs" / "images"
LARGEST = 150_000
PAGES = ("a-flight", "measure-a-part", "a-facade")
COMMANDS = re.compile(r"^```console\n(.*?)^```", re.MULTILINE | re.DOTALL)


def run(page: str, folder: Path) -> None:
    """The commands of a page, in a folder in which demo_data is."""
    for block in COMMANDS.findall((ROOT / "docs" / "tutorial" / f"{page}.md").read_text()):
        for line in block.strip().splitlines():
            if line.startswith("raybundle "):
                # 4: something that was asked for is not kept, and all is written
                done = subprocess.run([sys.executable, "-m", *shlex.split(line)], cwd=folder, check=False)
                if done.returncode not in {0, 4}:
                    sys.exit(f"{page}: {line}: exit status {done.returncode}")


def first_page(pdf: Path, name: str, *, dpi: int) -> None:
    """Page 1 of a PDF as PNG."""
    with TemporaryDirectory() as folder:
        made = Path(folder) / "page"
        subprocess.run(
            ["pdftoppm", "-png", "-r", str(dpi), "-f", "1", "-l", "1", "-singlefile", str(pdf), str(made)],
            check=True,
        )
        with Image.open(made.with_suffix(".png")) as opened:
            whole = opened.convert("RGB")
    for colours in (128, 64, 32, 16):
        whole.quantize(colours, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(IMAGES / name, optimize=True)
        if (IMAGES / name).stat().st_size <= LARGEST:
            break
    told(name)


def photograph(file: Path, name: str, width: int) -> None:
    """A photograph in small, as WebP."""
    with Image.open(file) as opened:
        small = opened.convert("RGB")
    small.thumbnail((width, width), Image.Resampling.LANCZOS)
    for quality in (80, 65, 50, 35):
        small.save(IMAGES / name, quality=quality, method=6)
        if (IMAGES / name).stat().st_size <= LARGEST:
            break
    told(name)


def side_by_side(files: list[Path], name: str, columns: int, width: int) -> None:
    """Photographs of one format in rows, with a gap, as WebP."""
    small: list[Image.Image] = []
    for file in files:
        with Image.open(file) as opened:
            small.append(opened.convert("RGB"))
            small[-1].thumbnail((width, width), Image.Resampling.LANCZOS)
    w, h, gap = *small[0].size, 6
    rows = -(-len(small) // columns)
    sheet = Image.new("RGB", (columns * (w + gap) - gap, rows * (h + gap) - gap), "white")
    for k, picture in enumerate(small):
        sheet.paste(picture, (k % columns * (w + gap), k // columns * (h + gap)))
    sheet.save(IMAGES / name, quality=70, method=6)
    told(name)


def told(name: str) -> None:
    """Its size."""
    print(f"docs/images/{name}: {(IMAGES / name).stat().st_size / 1000:.0f} kB")


def main() -> None:
    """Make all pictures."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "demo_data").symlink_to(ROOT / "demo_data")
        for page in PAGES:
            run(page, folder)
        first_page(folder / "pit-project/result/report.pdf", "report.png", dpi=96)
        first_page(folder / "before/report.pdf", "tutorial-part-report.png", dpi=96)
        first_page(folder / "portal/facade/sheet.pdf", "tutorial-facade-sheet.png", dpi=60)
        photograph(folder / "pit/photos/PIT_0008.jpg", "tutorial-flight-photograph.webp", 700)
        photograph(folder / "pit-map.tif", "tutorial-flight-map.webp", 700)
        photograph(folder / "part/before/before_01.jpg", "tutorial-part-photograph.webp", 800)
        make_set("board", folder / "board")
        board = [folder / f"board/photos/board_{k:02d}.jpg" for k in range(1, 9)]
        side_by_side(board, "tutorial-board-photographs.webp", 4, 250)
        photograph(folder / "demo_data/portal/photos/portal_03.jpg", "tutorial-facade-photograph.webp", 700)


if __name__ == "__main__":
    main()
