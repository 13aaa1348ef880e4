"""Flight plans, areas, listings of data sets and journals."""

import contextlib
import json
import sqlite3
import warnings
import zipfile
from pathlib import Path

from raybundle.io.missions import mission_formats
from tests.hostile.readers.registry import not_finite, only, place, target, texts

KML = (
    '<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Placemark><Polygon><outerBoundaryIs>'
    "<LinearRing><coordinates>11,48,0 11.1,48,0 11.1,48.1,0 11,48,0</coordinates></LinearRing></outerBoundaryIs>"
    "</Polygon></Placemark><Placemark><LineString><coordinates>11,48 11.1,48.1</coordinates></LineString></Placemark>"
    "<Placemark><Point><coordinates>11.05,48.05,3</coordinates></Point></Placemark></kml>"
)
AREA = {
    "type": "Polygon",
    "coordinates": [[[11.0, 48.0], [11.002, 48.0], [11.002, 48.001], [11.0, 48.001], [11.0, 48.0]]],
}


def mission_seeds(name: str):
    def write(top: Path) -> None:
        from raybundle.io.missions import routes_of
        from tests.missions.cases import mission

        for k, pattern in enumerate(("nadir", "orbit")):
            entry = mission_formats[name]
            entry.write(routes_of(mission(pattern))[0], place(top, k) / f"plan{entry.suffix}")

    return write


def read_a_mission(name: str):
    def read(folder: Path) -> list[str]:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of zipfile, about names that stand twice
            r = mission_formats[name].read(only(folder))
        return not_finite(latitude=r.latitude_deg, longitude=r.longitude_deg, height=r.height)

    return read


for _name in sorted(mission_formats):
    target(f"mission-{_name}", mission_seeds(_name), read_a_mission(_name))


def plan_seeds(top: Path) -> None:
    from raybundle.io.missions.mission_file import write_mission
    from tests.missions.cases import mission

    write_mission(mission("nadir"), place(top) / "mission.toml")


def read_a_plan(folder: Path) -> list[str]:
    from raybundle.io.missions.mission_file import read_mission

    read_mission(only(folder))
    return []


target("mission", plan_seeds, read_a_plan)


def area_seeds(top: Path) -> None:
    for k, method in enumerate((zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)):
        with zipfile.ZipFile(place(top, k) / "a.kmz", "w", method) as archive:
            archive.writestr("doc.kml", KML)
    (place(top, 2) / "a.kml").write_text(KML)
    (place(top, 3) / "a.geojson").write_text(json.dumps(AREA))
    features = {"type": "Feature", "properties": {"name": "a"}, "geometry": AREA}
    (place(top, 4) / "a.json").write_text(json.dumps({"type": "FeatureCollection", "features": [features]}))


def read_an_area(folder: Path) -> list[str]:
    from raybundle.io.missions.areas import read_shapes

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        return [w for s in read_shapes(str(only(folder))) for w in not_finite(outline=s.xy)]


target("area", area_seeds, read_an_area)
LISTING = (
    '[a]\nabout = "x"\nsource = "https://host/x"\nbase = "https://[2001:db8::1]:8080/x/"\nlicence = "CC0"\n'
    f'files = [["a/b.jpg", 1234, "{"0" * 64}"], ["c.txt", 5, "{"1" * 64}"]]\n'
)


def read_a_listing(folder: Path) -> list[str]:
    from raybundle.io.datasets import known_datasets

    return [s.name for s in known_datasets(only(folder)).values() if not s.size > 0]


target("datasets", texts({"d.toml": LISTING}), read_a_listing)


def journal_seeds(top: Path) -> None:
    with contextlib.closing(sqlite3.connect(place(top) / "block.measured.db")) as db, db:
        db.execute("CREATE TABLE about (name TEXT PRIMARY KEY, value TEXT NOT NULL)")
        db.execute("INSERT INTO about VALUES ('schema', '1')")
        db.execute("CREATE TABLE actions (seq INTEGER PRIMARY KEY, id, time, author, verb, arguments)")
        for k, (verb, arguments) in enumerate(
            [("measure", {"image": "a", "point": "p", "x_px": 1.5, "y_px": 2.5}), ("undo", {}), ("redo", {})]
        ):
            row = (f"id{k}", "2026-01-01T00:00:00.000+00:00", "", verb, json.dumps(arguments))
            db.execute("INSERT INTO actions (id, time, author, verb, arguments) VALUES (?, ?, ?, ?, ?)", row)


def read_a_journal(folder: Path) -> list[str]:
    from raybundle.errors import InputError
    from raybundle.measuring.journal import entries_of

    found = entries_of(folder / "block.measured.db") if (folder / "block.measured.db").exists() else []
    for entry in found:
        with contextlib.suppress(InputError):
            _ = entry.action
    return [] if all(isinstance(e.arguments, dict) for e in found) else ["arguments"]


target("journal", journal_seeds, read_a_journal)
