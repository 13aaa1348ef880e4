"""What pages take for granted: photographs, control and projects of a reader, made once in a run of the tests.

A page that begins with `<!-- tried with: facade, flight-project -->` finds these in the folder where its commands run.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from tests.barriers import wait_for

REPOSITORY = Path(__file__).resolve().parents[2]
PORTAL = REPOSITORY / "demo_data/portal"
TEST = "<!-- test -->"
"""Stands in a page for the next part (`# %%`) of tests/docs/pages/PAGE.py"""


def with_tests(page):
    """Text of a page with the parts of its file of tests."""
    first, *others = page.read_text().split(TEST)
    parts = (REPOSITORY / f"tests/docs/pages/{page.stem}.py").read_text().split("# %%")[1:] if others else []
    return first + "".join(f"```python\n#{part}\n```{other}" for part, other in zip(parts, others, strict=True))


def raybundle(folder, *words):
    done = subprocess.run(
        [sys.executable, "-m", "raybundle", *words], cwd=folder, capture_output=True, text=True, check=False,
        env=os.environ,
    )  # fmt: skip
    assert done.returncode == 0, (words, done.stdout[-2000:], done.stderr[-2000:])


def facade(folder):
    """Fourteen photographs of a portal, where the ends A, B of a bar and points T1 to T8 of the wall are in them."""
    shutil.copytree(PORTAL / "photos", folder / "facade")
    shutil.copy(PORTAL / "measured.csv", folder / "marks.csv")


def facade_project(folder):
    facade(folder)
    raybundle(folder, "orient", "facade", "--out", "facade-project", "--control", "marks.csv",
              "--scale-bar", "A", "B", "1.2319", "0.0001")  # fmt: skip


def dates(folder):
    """Photographs of a portal as of three dates; nothing moved."""
    for k, photo in enumerate(sorted((PORTAL / "photos").glob("*.jpg"))):
        part = folder / ("may", "june", "july")[k % 3]
        part.mkdir(exist_ok=True)
        shutil.copy(photo, part)


def specimen(folder):
    """Images of a specimen before and under load, which is pulled to the right."""
    from PIL import Image

    from tests.matching.specimen import deformed, image, motion

    Image.fromarray(image(0)).save(folder / "load-00.png")
    for k in (1, 2):
        F, shift = motion(0.2 * k, strain=(0.004 * k, -0.0012 * k, 0.0), shift=(0.7 * k, 0.1))
        Image.fromarray(deformed(k, F, shift)).save(folder / f"load-0{k}.png")


def flight(folder):
    """Eighteen photographs from a drone, control and check points, and how the camera hung as its gimbal tells."""
    raybundle(folder, "demo", "--set", "flight", "--out", "pit")
    (folder / "pit/photos").rename(folder / "flight")
    for name in ("gcp_list.txt", "checks.csv", "checks-measurements.csv"):
        (folder / "pit" / name).rename(folder / name)
    (folder / "pit").rmdir()


def flight_project(folder):
    flight(folder)
    raybundle(
        folder, "orient", "flight", "--out", "flight-project", "--control", "gcp_list.txt", "--check", "checks.csv"
    )


def part(folder):
    """Twelve photographs of a plate with AICON targets, its drawing and known lengths."""
    raybundle(folder, "demo", "--set", "part", "--out", "made")
    (folder / "made/before").rename(folder / "photos")
    for name in ("nominal.csv", "lengths.csv"):
        (folder / "made" / name).rename(folder / name)
    shutil.rmtree(folder / "made")


def turntable(folder):
    """Photographs, and masks of a corner of each."""
    import numpy as np
    from PIL import Image

    shutil.copytree(PORTAL / "photos", folder / "turntable/photos")
    (folder / "turntable/masks").mkdir()
    for photo in sorted((folder / "turntable/photos").iterdir()):
        with Image.open(photo) as picture:
            used = np.full((picture.height, picture.width), 255, np.uint8)
        used[:80, :120] = 0
        Image.fromarray(used).save(folder / f"turntable/masks/{photo.stem}.png")


def studio(folder):
    """A folder of photographs, and another from an archive."""
    shutil.copytree(PORTAL / "photos", folder / "photos")
    (folder / "archive").mkdir()
    for number in ("01", "02", "03"):
        shutil.copy(PORTAL / f"photos/portal_{number}.jpg", folder / "archive")


def survey(folder):
    """Photographs of a flight that a GNSS and INS was with: ins.csv, grid.csv, eo.txt, and the gimbal in their XMP.

    The attitudes are those of an adjustment, with errors of 0.2 degrees.
    """
    import csv

    import numpy as np
    from PIL import Image

    from raybundle.io.geo.coordinate_systems import local_frame
    from raybundle.io.trajectories import Trajectory, write_trajectory
    from raybundle.numerics.attitude import GON, gimbal_from_rotation, pok_from_rotation
    from raybundle.numerics.rotation import rotation_from_angles, rotation_from_vector

    flight_project(folder)
    with (folder / "flight-project/result/images.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    n, rng = len(rows), np.random.default_rng(3)
    centre = np.array([[float(r[a]) for a in "XYZ"] for r in rows])
    angles = np.radians([[float(r[f"{a}_deg"]) for a in ("omega", "phi", "kappa")] for r in rows])
    rotation = rotation_from_vector(rng.normal(0, np.radians(0.2), (n, 3))) @ rotation_from_angles(angles)
    for name, crs in (("ins.csv", "EPSG:4979"), ("grid.csv", "EPSG:32633")):
        frame = local_frame(crs, (13.0, 51.0, 200.0) if crs == "EPSG:4979" else (360000.0, 5650000.0, 200.0))
        trajectory = Trajectory(
            path=folder / name, names=tuple(r["image"] for r in rows), crs=crs, sigma=np.full((n, 3), 0.03),
            xyz=frame.crs_from_local(centre + rng.normal(0, 0.03, centre.shape)), rotation=rotation,
            rotation_sigma=np.full((n, 3), np.radians(0.2)), true_north=crs == "EPSG:4979",
        )  # fmt: skip
        write_trajectory(trajectory, folder / name, name="opk")
    phi_first = pok_from_rotation(trajectory.rotation) / GON
    lines = zip(trajectory.names, trajectory.xyz.tolist(), phi_first.tolist(), strict=True)
    (folder / "eo.txt").write_text("".join(f"{n} {' '.join(map(str, [*x, *a]))}\n" for n, x, a in lines))
    (folder / "survey").mkdir()
    for row, (yaw, pitch, roll) in zip(rows, np.degrees(gimbal_from_rotation(rotation)), strict=True):
        told = XMP.format(yaw=yaw, pitch=pitch, roll=roll).encode()
        with Image.open(folder / "flight" / row["image"]) as photo:
            photo.save(folder / "survey" / row["image"], quality="keep", exif=photo.info["exif"], xmp=told)
    for made in ("flight", "flight-project"):
        shutil.rmtree(folder / made)


XMP = (
    '<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">'
    '<rdf:Description xmlns:drone-dji="http://www.dji.com/drone-dji/1.0/" drone-dji:GimbalYawDegree="{yaw:.2f}" '
    'drone-dji:GimbalPitchDegree="{pitch:.2f}" drone-dji:GimbalRollDegree="{roll:.2f}"/></rdf:RDF></x:xmpmeta>'
)


def flown(folder):
    """What a drone brought from the mission that docs/how-to/plan-a-flight.md plans."""
    from raybundle.io.missions.mission_file import read_mission
    from tests.missions.flying import fly

    corners = "7.1 50.1, 7.104 50.1005, 7.1038 50.103, 7.0995 50.1022"
    raybundle(folder, "plan", "mission", corners, "--vehicle", "mavic-3e", "--gsd", "0.02", "--out", "planned")
    (folder / "DCIM").mkdir()
    fly(read_mission(folder / "planned/mission.toml"), folder / "DCIM/100MEDIA", off=0.5)
    shutil.rmtree(folder / "planned")


def heights(folder):
    """Heights as `raybundle surface --dsm` writes them: a pit in a map, and a wall in May and October."""
    import numpy as np
    from rasterio.crs import CRS

    from tests.surface.height_models import folder_of, made, middles

    rng = np.random.default_rng(1)
    x, y = middles((240, 320), 0.25)
    terrain = 0.04 * x + 0.5 * np.sin(y / 12)
    terrain += np.maximum(6 - 0.5 * np.hypot(x - 40, y - 30), 0)
    terrain[30:46, 250:280] += 3.5
    terrain[180:186, 60:78] += 2.5
    for name in ("pit", "may", "october"):
        (folder / name).mkdir()
    pit = made(terrain, cell=0.25, sigma=0.03, common=0.02, rng=rng)
    folder_of(
        pit, folder / "pit/surface", left=360000.0, top=5650060.0, wkt=CRS.from_epsg(32633).to_wkt()
    )  # fmt: skip
    x, y = middles((160, 240))
    wall = 0.004 * np.sin(9 * x) * np.cos(7 * y)
    folder_of(made(wall, sigma=4e-4, common=1e-3, rng=rng), folder / "may/surface")
    wall[60:90, 100:130] += 0.003
    folder_of(made(wall, sigma=4e-4, common=1e-3, rng=rng), folder / "october/surface")


def pit_project(folder):
    """A block and a surface beside it that a line can be drawn on."""
    import numpy as np

    from raybundle.io.block.folder import write_block
    from raybundle.planning.simulate import Survey, simulate
    from tests.surface.height_models import folder_of, made
    from tests.workflows.dated_network import SCENE

    write_block(simulate(SCENE, Survey(seed=1)).observed, folder / "pit-project")
    slope = made(
        np.tile(np.linspace(0, 2, 90), (60, 1)), cell=0.1, sigma=0.01, common=0.01, rng=np.random.default_rng(1)
    )
    folder_of(slope, folder / "pit-project/surface")


def quarry(folder):
    """Surfaces of a quarry at three dates, whose piles grow and shrink, their outlines, and an older model."""
    from tests.surface.quarry import written

    written(folder)


SAMPLES = {
    "heights": heights,
    "quarry": quarry,
    "pit-project": pit_project,
    "dates": dates,
    "specimen": specimen,
    "facade": facade,
    "facade-project": facade_project,
    "flight": flight,
    "flight-project": flight_project,
    "part": part,
    "survey": survey,
    "flown": flown,
    "turntable": turntable,
    "studio": studio,
}


def lay_out(name, shared, folder):
    """Copy a sample into a folder; made in `shared` where it is not there yet, by one of the processes of the tests."""
    made = shared / f"sample-{name}"
    lock = shared / f"sample-{name}.lock"
    try:
        lock.mkdir()
    except FileExistsError:
        wait_for(made.exists, f"sample {name} is made by the process that began it", 1200)
    else:
        fresh = shared / f"sample-{name}.making"
        fresh.mkdir()
        SAMPLES[name](fresh)
        fresh.rename(made)
    shutil.copytree(made, folder, dirs_exist_ok=True)
