"""Reports in other languages: every English text is covered by every catalogue, and every entry is needed."""

import json
import re
from dataclasses import replace
from datetime import UTC, datetime
from functools import cache
from html import unescape
from pathlib import PurePath

import pytest

import raybundle
from raybundle.adjustment.result import Notice
from raybundle.adjustment.severity import Severity
from raybundle.block import Role
from raybundle.errors import InputError
from raybundle.observations import observation_kinds
from raybundle.platforms import instrument_models
from raybundle.report.document import write_report
from raybundle.report.languages import ENGLISH, Said, catalogue, language_codes
from raybundle.report.languages.language import Language, book_of, language_of
from raybundle.report.languages.patterns import Template
from raybundle.report.paper.copy import copy_of
from raybundle.results.record import NAMES
from raybundle.sensors import sensor_models

from .conftest import MAKERS, made
from .english_texts import SOURCE, Text, flat, texts_of

OTHERS = [c for c in language_codes() if c != ENGLISH]
SIMULATED = [name for name in MAKERS if name != "hostile"]

APART = {
    "report/compare.py": "a page of `compare`, which has no language",
    "report/differences.py": "the same",
    "report/shared.py": "the same",
    "report/common_points.py": "a page of `merge`, which has no language",
    "report/sameness.py": "printed by `compare`",
    "report/photograph_list.py": "a list of `plan`, which has no language",
    "report/text/summary.py": "printed on the command line",
    "report/show.py": "opens pages",
    "ties/pairs.py": "which pairs are matched: told in the line of a stage",
    "ties/parts.py": "tasks of a start in parts, told while it goes on",
    "ties/tracks.py": "tasks of tracks, told while they go on",
    "ties/windows.py": "tasks of least-squares matching, told while it goes on",
    "report/tables.py": "tables for Python",
    "report/plotting.py": "figures of matplotlib for Python",
    **dict.fromkeys((f"report/plots/{f.name}" for f in (SOURCE / "report" / "plots").glob("*.py")), "the same"),
    **dict.fromkeys(
        ("adjustment/dense.py", "adjustment/twin.py", "adjustment/fields.py", "adjustment/entry.py"), "computes"
    ),
    **dict.fromkeys(("adjustment/shown.py", "adjustment/handle.py", "adjustment/queries.py"), "for notebooks"),
    **dict.fromkeys(("adjustment/options.py", "adjustment/asked_parameters.py"), "settings and their help"),
    "adjustment/severity.py": "codes; its words are registered",
    "adjustment/scene_start.py": "errors that end a run",
    "adjustment/accuracy_class.py": "how a class is asked for; its words are in the report's own module",
}
"""Modules that make nothing of a report"""
BESIDE = (
    "adjustment/*.py", "block/rejection.py", "block/known.py", "calibration/quality.py", "calibration/one_camera.py",
    "commands/photograph_facts.py", "commands/drawn.py", "workflows/plumb.py", "workflows/object_plane.py",
    "io/photos/cameras.py", "io/photos/start.py", "io/photos/container.py",
    "io/photos/photo.py", "io/photos/masks.py", "io/geo/coordinate_systems.py",
    "block/frames.py", "orientation/assembly.py", "orientation/projective.py",
    "orientation/start.py", "orientation/lacking.py", "planning/next_words.py", "results/recorded.py",
    "ties/*.py", "placing/*.py",
    "workflows/orienting/*.py", "workflows/scenes/*.py", "workflows/calibrating/*.py",
)  # fmt: skip
"""Modules that make texts for reports without making a notice"""
REMARKS = re.compile(r"\bremarks?\b")
"""A module with a word of these tells its caller something, which becomes a notice as a rule"""
SENTENCE = re.compile(r"(?:\S+ ){4}")
"""What such a module tells has more than four words; its other texts are names and keys"""
SAID_ELSEWHERE = {
    "cli/": "printed on the command line",
    "commands/": "the same; what is none makes a notice",
    "studio/": "shown in the studio",
    "measuring/": "answers of the studio and of `query`",
    "planning/": "answers of `plan`",
    "missions/": "the same",
    "io/missions/": "the same",
    "io/formats/": "remarks of `convert`",
    "io/calibrations/": "of `calibration`",
    "io/pictures/": "of `rectify` and of `convert`",
    "io/scene_export.py": "of `convert`",
    "io/photos/video.py": "of `frames`",
    "io/cameras/one_instant.py": "of `convert`",
    "block/zoom.py": "of `camera`",
    "block/joined.py": "of `merge`",
    "workflows/convert.py": "of `convert`",
    "workflows/sources.py": "the same",
    "workflows/rectify.py": "the same",
    "io/film/": "of `film`",
    "io/geo/rasters.py": "of `rpc ortho`",
    "workflows/bare.py": "an error that ends a run",
    "objects/": "of `plan`",
    "workflows/scenes/ortho.py": "of `rpc ortho`",
}
"""Modules whose remarks reach no report, and who reads them"""
CODES = frozenset(
    """
    antenna interior most one planar small systematic watermark
    CalibratedFocalLength DejaVuSansCondensed both centres converge corners dx dy dz roll several views
    DejaVuSansCondensed-Bold DewarpData Found Gps JpegImageFile JpegImagePlugin LineSensor
    Metadata
    PerspectiveFocalLength Photo PngImageFile PngImagePlugin RpcSensor SceneSensor TiffImageFile
    TiffImagePlugin WebPImageFile WebPImagePlugin any approximate auto ax ay az best big brown
    calibrate close csr decisions
    descriptors end facts fields figures first fisheye folded fonts ft general gnss gps heading heic
    horizontal html ignore
    inner ins jpeg known language last length lens levelled little middle minimal misfit mwMW@%‰—…∞√≥≤ named names
    nan natural notes factoring
    numpy order orient paragraph png pointer pushbroom rad rational raw rawpy raybundle rb recognised relief report
    scipy second sha256 shift snooping specialist spherical start statements stay sx sy sz table templates tiff
    trouble upright values vertical vx vy vz webp white window wx wy wz xy
    """.split()  # noqa: SIM905  (read like a text)
)
"""Names within the program and its formats, which no reader sees"""
ENDING = (
    "usable photograph{}", "one photograph alone cannot", "1 satellite scene and no photograph",
    "give a folder of photographs", "this line has no name of a point", "has other coordinates in line",
    "this point stands in image", "is not one of control, check, tie", "give the coordinate too",
    "has no coordinate; give", "longitude {} to {}, latitude", "a frame camera, whose",
    "a push-frame camera", "a radar, which", "or leave {} out", "does not fit on", "for sheets that are joined",
    "at any scale", "with {} sheets",
    "have a depth, and other photographs do not confirm", "nothing could be measured{}: {}",
)  # fmt: skip
"""Errors that end a run, made in parts: there is no report then"""
FORMATS = re.compile(r"ISD|DIMAP [12]|GeoTIFF with|metadata XML|RPC as text|MRK file|PhotoModeler's|apriltag-36h11")
"""What formats and targets are called in lists of the command line"""
PRINTED = (
    "the picture was made of block", "the unit of the picture is not told", "; two suffice for",
    "its points lean {}, and",
    "the wall is not plumb by", "the plane was made plumb as asked", "seen by less than two images",
    "Wanted: a coordinate",
    "Red is what would be worse",
)  # fmt: skip
"""What the command line or a page of `plan` says, of modules that make texts of sheets and reports"""
STANDARD = "report/text/accuracy_words.py"
"""Statements of ASPRS, which stand in the words of the standard in every language"""


@cache
def classes() -> frozenset[str]:
    """Names of styles."""
    css = (SOURCE / "report" / "templates" / "style.css").read_text(encoding="utf-8")
    return frozenset(re.findall(r"\.([a-z]\w*)", css)) | {"light", "lost", "tiny", "first", "key", "frame"}


def excused(t: Text) -> bool:
    """Whether a text is none for a reader."""
    words = t.template.replace("{}", " ").split()
    return (
        t.template in CODES
        or (t.file.startswith("report/figures/") and all(w in classes() for w in words))
        or bool(re.search(r'="|\{font|font-family|<title>', t.template))
        or (
            re.fullmatch(
                r"\{?\}?-?[A-Za-z.]*-?\{?\}?(Sensor( \| \w+)?|\[Photo\]|-appendix|result-)?(\{\})?", t.template
            )
            is not None
            and ("-" in t.template or "[" in t.template or "|" in t.template)
        )
        or (t.file == STANDARD and bool(re.search("checkpoints|data set|Accuracy|positional|thirty", t.template)))
        or t.template in {"Libertinus Serif", "no residual", "vector bold"}
        or re.fullmatch(r"\{\}:\w+_of", t.template) is not None
        or any(words in t.template for words in (*ENDING, *PRINTED))
        or FORMATS.search(t.template) is not None
    )


@cache
def sources() -> tuple[Text, ...]:
    """All texts that can reach the reader of a report."""
    found: list[Text] = []
    for path in sorted(SOURCE.rglob("*.py")):
        name = path.relative_to(SOURCE).as_posix()
        if name in APART or name.startswith("report/languages/"):
            continue
        if (
            name.startswith("report/")
            or any(PurePath(name).match(p) for p in BESIDE)
            or "Notice(" in (text := path.read_text(encoding="utf-8"))
        ):
            found += texts_of(path)
        elif REMARKS.search(text) and not name.startswith(tuple(SAID_ELSEWHERE)):
            found += (t for t in texts_of(path) if SENTENCE.search(t.template))
    return tuple(found)


def registered() -> set[str]:
    """Texts of what registers itself: a new sensor, platform, instrument or kind of observation has them, too."""
    models = [*sensor_models.values(), *instrument_models.values()]
    words = {re.sub(r"\b\d+\b", "1", p.meaning) for m in models for p in m.parameters}
    for kind in observation_kinds.values():
        words |= {
            kind.title,
            kind.quantities,
            kind.group,
            kind.name,
            kind.object,
            *kind.components,
            *([kind.noun] if kind.noun else []),
        }
    own = (SOURCE / "report" / "templates").glob("*.j2")
    said = {w for f in own for w in re.findall(r'language\.text\("([^"]+)"\)', f.read_text(encoding="utf-8"))}
    return {*words, *said, *(r.name.lower() for r in Role), *NAMES, *(s.value for s in Severity)} - {""}


def uncovered(texts, language: Language, used: set[str]):
    """Texts that a catalogue does not cover, those at their places included."""
    c = catalogue(language.code)
    for t in texts:
        if t.template in c["texts"]:
            used.add(t.template)
            told = Template(t.template, c["texts"][t.template]).reported
            for k, within in enumerate(t.within):
                if k in told:
                    yield from uncovered(within, language, used)
                else:
                    used |= {w.template for w in flat(within)}
        elif t.template in c["nouns"]:
            used.add(t.template)
        else:
            if not excused(t) and language.left(t.template.replace("{}", "7")) >= 1:
                yield t
            for within in t.within:
                yield from uncovered(within, language, used)


@pytest.mark.long
@pytest.mark.parametrize("code", OTHERS)
def test_every_text_of_the_source_is_in_the_catalogue_and_no_other(code):
    language, used = language_of(code), set[str]()
    lacking = {t.template: t for t in uncovered(sources(), language, used)}
    lines = [f"# {t.file}:{t.line}\n{json.dumps(t.template, ensure_ascii=False)} = " + '""' for t in lacking.values()]
    lines += [f'{json.dumps(w, ensure_ascii=False)} = ""' for w in sorted(registered()) if language.left(w) >= 1
              and w not in catalogue(code)["nouns"]]  # fmt: skip
    assert not lines, (
        f"{len(lines)} English texts are not in report/languages/{code}.toml.  Paste these into its [texts] and "
        "translate them (docs/how-to/report-language.md); what no reader sees goes into CODES or APART here:\n"
        + "\n".join(lines)
    )
    every = {t.template for t in flat(list(sources()))} | registered() | used | MADE
    left = [e for e in catalogue(code)["texts"] if e not in every]
    assert not left, (
        f"no source text is any of these entries of {code}.toml; take them out, or mend them:\n" + "\n".join(left)
    )


MADE = {
    "So many image points take about {} GB however they are cut; where that is not there, leave out some",
    ". Standard deviations of dense points are those along the ray.", "shows nothing of the region",
    "the report of the result says by how much", "heights in {} are relative: none of the control was measured",
    "{}, {} of them, beside the area of the heights, that of the tie points; {} holds all but 0.1 % at each edge",
    "{}: in none of the folders of the photographs", "{}: of {} px, its camera of {}",
    "{}: of an earlier run, {}, beside points.ply {}; made alike with {}", "with all points", "thinned by {}",
    "{}: of an earlier run, of the same points", "{}: removed, it was of other points; ask for it with {}",
    "Scene {}", "Strip {}", "scene {}", "shift in {}, knot {}, {}", "velocity", "feet", "across X", "across Y",
    "not connected", "no approximate orientation for {} of {} images: {}", "fits no other photograph",
    "not one and the same picture at a whole multiple or part of its size",
    "the photograph is used whole", "the mask has {} x {} px, the photograph {} {} x {}",
    "the pixels cannot be decoded ({})", "interior orientation", "plumb line", "coded", "marked", "weights",
    "{} leaves the positions out", "metre", "foot", "US survey foot", "degree", "start", "cameras", "precision",
    "scene features", "scene matching", "scene start", "scene precision", "verdict", "known", "recognised", "result",
    "image file is truncated", "relative aerial control: the positions of {} are used by their differences",
    "differences", "coordinates", ", kept on {}", "image observations times {}", "image observations as given",
    "is observed with its covariance", "is held: its covariance is not known",
    "; it was called {}", "the calibration {} of the camera library{} {}{} ({}: estimate it)",
    "Plane", "straight line", "across the plane {}", "origin {}, right level",
    "no photograph has a position", "{} found, {} are needed{}",
}  # fmt: skip
"""Entries for what is put together of words, or is an error that a notice quotes, and stands nowhere as it is read"""


@pytest.mark.parametrize("code", OTHERS)
def test_places_of_an_entry_are_those_of_the_english_text(code):
    for english, other in catalogue(code)["texts"].items():
        assert other, english
        places = {k for _, k, _, _ in Template(english, other).pieces if k >= 0}
        assert max(places, default=-1) < english.count("{}"), english


def english_atoms(language: Language, run) -> list[str]:
    """What of a run stays English."""
    left: list[str] = []
    plain = Language.text

    def watched(self, english):
        if self.code == language.code and not isinstance(english, Said) and self.left(english) >= 1:
            left.append(f"{english}\n    {plain(self, english)}")
        return plain(self, english)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Language, "text", watched)
        run()
    return left


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", ["rich", "rejected"])
def test_no_atom_of_a_report_stays_english(code, name, tmp_path):
    adjustment = made(name)
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


@pytest.mark.long
@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", [n for n in SIMULATED if n not in {"rich", "rejected"}])
def test_no_atom_of_any_simulated_report_stays_english(code, name, tmp_path):
    adjustment = made(name)
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


BLOCKS = ("aicon", "camcal21", "prague-s1", "rc30-pair", "resection-wuhan", "riva-net1", "sxb")


@pytest.mark.long
@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", BLOCKS)
def test_no_atom_of_a_measured_block_stays_english(code, name, tmp_path, blocks):
    folder = blocks / name
    if not folder.is_dir():
        pytest.skip(f"{folder} is not here")
    adjustment = raybundle.adjust(raybundle.read_block(folder))
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


def test_a_text_that_is_not_covered_is_noticed(tmp_path):
    adjustment = replace(made("rich"), notices=(Notice(code="gps", message="somebody moved the tripod"),))
    left = english_atoms(language_of("de"), lambda: write_report(adjustment, tmp_path / "r.html", language="de"))
    assert any("tripod" in words for words in left)


def test_a_sentence_without_translation_stays_english_whole():
    german = language_of("de", ["mill.csv"])
    lost = (
        "mill.csv: all 4 wheels are perfectly round and are taken as unknown, not measured: the miller or check alone"
    )
    known = "12 images"
    assert german.text(lost) == lost
    assert german.left(lost) >= 1
    assert german.text(f"{lost}. Reports are written in German. {known}") == (
        f"{lost}. Reports are written in German. 12 Bilder"
    )


def test_numbers_dates_counts_and_names():
    german = language_of("de", ["IMG_1.5", "control", "front wall"])
    assert german.text("X 0.12, Y 0.3, Z 1.25 mm") == "X 0,12; Y 0,3; Z 1,25 mm"
    assert german.text("2026-11-26") == "26.11.2026"
    assert german.text("1 image") == "1 Bild"
    assert german.text("12 images") == "12 Bilder"
    assert german.cell("IMG_1.5") == "IMG_1.5"
    assert german.cell("control") == "control"  # a point of this name
    for english, told in (
        ("RMSE_H = 23 mm from 6 check points", "RMSE_H = 23 mm aus 6 Kontrollpunkten"),
        ("of 34", "von 34"),
        ("of 73 points", "von 73 Punkten"),
        ("27 of 73 points", "27 von 73 Punkten"),
    ):
        assert german.text(english) == told
    assert german.moment(datetime(2026, 11, 6, 8, 30, tzinfo=UTC)) == "06.11.2026 08:30"


def test_english_is_left_alone():
    english = language_of()
    assert english.text("12 images, 0.5 px") == "12 images, 0.5 px"
    assert english.english


def test_the_page_says_its_language(tmp_path):
    for code in language_codes():
        write_report(made("rich"), tmp_path / "r.html", language=code)
        page = (tmp_path / "r.html").read_text(encoding="utf-8")
        assert f'<html lang="{code}">' in page
    write_report(made("rich"), tmp_path / "r.html", language="de")
    page = unescape((tmp_path / "r.html").read_text(encoding="utf-8"))
    assert "Für den Auftraggeber" in page
    assert "Standardabweichung" in page


def test_paper_says_its_language():
    from raybundle.report.document import Document

    document = Document(title="x", subtitle="", headline="", grade="good", made=(), language=language_of("de"))
    copy = copy_of(document)
    assert copy["language"] == "de"
    assert copy["page"] == ["Seite", "von"]


def test_a_language_that_there_is_not_is_refused(tmp_path):
    with pytest.raises(InputError, match="en, de"):
        write_report(made("rich"), tmp_path / "r.html", language="xx")


@pytest.mark.parametrize("code", OTHERS)
def test_a_catalogue_is_whole(code):
    book = book_of(code)
    assert book.exact
    assert book.index
