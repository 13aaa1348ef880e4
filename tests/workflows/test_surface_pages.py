"""What people are told of a surface: the verdict and the warnings of its adjustment, whom it is for, what it holds."""

import re
import shutil
import tomllib
from dataclasses import replace

import pytest

import raybundle as rb
from raybundle.adjustment.records.notice import Notice
from raybundle.adjustment.records.severity import Severity
from raybundle.cli.main import main
from raybundle.cli.surface import whole_shares
from raybundle.commands import surface as command
from raybundle.commands.surface_pages import outside_words
from raybundle.io.block.folder import read_block
from raybundle.io.geo.parsed_names import system_with_heights
from raybundle.report.text.numbers import unbroken
from raybundle.report.write import write_result
from raybundle.results.notices import as_its_result
from raybundle.results.record import Record
from raybundle.surfaces.product_grids import Grids, area_of_points
from raybundle.words import COMMAND_LINE, Reader, headline, reading
from raybundle.workflows.rectify import grid_over
from tests.cli.reported import reported, values_of

pytest.importorskip("rasterio")

FAULT = "camera X: the photographs contradict its calibration, which is held"
CAUTIONS = ("up is ambiguous", "the only scale bar is checked by nothing", "control of one ray: G5", "one more matter")
RELATIVE, CHOSEN = "heights are relative", "what was chosen"


def result_of(half, folder, notices):
    """A result of the three photographs of which this is told."""
    adjusted = rb.adjust(read_block(half / "given"))
    record = Record(title="North front", client="Monument office", object="Portal")
    write_result(replace(adjusted, notices=notices), folder, report="none", record=record)
    return folder


@pytest.fixture(scope="module")
def warned(half, tmp_path_factory):
    """What the command prints of a result with a fault, cautions and heights that nobody measured, and its folder."""
    folder = tmp_path_factory.mktemp("warned")
    notices = (
        Notice(code="a", message=FAULT, measured=Severity.FAULT),
        *(Notice(code=f"c{k}", message=m, measured=Severity.WARNING) for k, m in enumerate(CAUTIONS)),
        Notice(code="levelled", message=RELATIVE),
        Notice(code="r", message=CHOSEN, measured=Severity.NOTE),
    )  # fmt: skip
    return result_of(half, folder / "result", notices)


@pytest.fixture(scope="module")
def measured(half, warned, copy_of_surface):
    copy_of_surface(warned / "surface")
    done = command.surface(
        warned, photos=(half,), density="4", dsm=0.05, thin=0.1, jobs=1, client="Somebody else",
        extent=None,
    )  # fmt: skip
    return done, warned / "surface"


def test_notices_of_a_result_are_those_of_its_adjustment_made_again(warned):
    again = as_its_result(rb.adjust(read_block(warned / "block")), warned)
    assert [n.text for n in again.notices if n.severity is Severity.FAULT] == [FAULT]
    assert sum(n.severity is Severity.WARNING for n in again.notices) == 5


def test_the_page_has_the_verdict_the_warnings_and_whom_it_is_for(measured):
    done, out = measured
    text = (out / "surface.html").read_text().replace("\N{NO-BREAK SPACE}", " ")
    assert '"verdict attention"' in text
    assert headline("front.faults", {"n": 1}) in text
    for words in (FAULT, *CAUTIONS, RELATIVE):
        assert words in text, words
    assert CHOSEN not in text  # remarks stay in the report of the result
    for words in ("North front", "Somebody else", "Portal", "points.ply", "heights_sigma.tif", "surface_3d.html"):
        assert words in text, words
    assert "Monument office" not in text  # of the record, what is said anew goes before it
    points = unbroken(headline("report_surface.thinned_maps", {"n": 3, "of": len(done.surface)}))
    assert points in text


def test_files_of_heights_say_what_forbids_their_use(measured):
    _, out = measured
    state = tomllib.loads((out / "heights.toml").read_text())["state"]
    assert FAULT in state
    assert "relative" in state


def test_a_surface_without_warnings_praises_itself_no_more_than_its_adjustment(half, tmp_path):
    done = command.surface(result_of(half, tmp_path / "r", ()), photos=(half,), density="4", jobs=1,
                           extent=(-0.2, -0.2, 0.2, 0.2))  # fmt: skip
    assert done.pages.warnings == ()
    assert '"verdict attention"' not in (tmp_path / "r/surface/surface.html").read_text()
    told = [float(v[0]) for v in done.pages.summary.axes]
    assert done.median_sigma >= max(told) - 1e-9
    assert done.median_along_ray != done.median_sigma
    assert abs(sum(done.shares) - 1) < 1e-9


def test_the_command_tells_the_fault_and_the_gravest_cautions_and_names_its_pages(half, warned, measured, capsys):
    del measured  # it is there, so that nothing is measured again
    words = ["--photos", str(half), "--density", "4", "--dsm", "0.05", "--jobs", "1", "--thin", "0.1"]
    assert main(["surface", str(warned), *words]) == 0
    short = capsys.readouterr().out
    assert f"fault: {FAULT}" in short
    assert short.count("warning: ") == 2
    assert re.search(r"(?m)^and 3 more", short)
    assert main(["surface", str(warned), *words, "--verbose"]) == 0
    stated = capsys.readouterr().out
    assert f"warning: {RELATIVE}" in stated  # of all points, before what is of single marks
    assert f": {headline('state.faults', {'n': 1})}" in stated
    assert str(warned / "surface/surface_3d.html") in stated
    assert main(["surface", str(warned), *words, "--json"]) == 0
    found = values_of(reported(capsys))
    assert found["surface.points"]["maps"] == 3
    assert found["surface.precision_of_axes"]["unit"] == "mm"
    assert sum(found["surface.shares"].values()) == 100


def test_status_of_a_result_of_its_surface_and_of_its_work_tells_the_stages(warned, measured, capsys):
    _, out = measured
    for folder in (warned, out, out / "work"):
        assert main(["status", str(folder)]) == 0
        stated = capsys.readouterr().out
        for stage in ("sources", "depth maps", "fusion", "heights"):
            assert re.search(rf"^{stage} +\d", stated, re.MULTILINE), (folder, stated)
        assert "matching" not in stated
        assert "orthophoto" not in stated  # nobody asked for one
        assert f"{out / 'work'} " in stated  # it may be deleted


def test_status_tells_of_a_result_that_was_adjusted_again(warned, measured, tmp_path, capsys):
    del measured
    shutil.copytree(warned, tmp_path / "r", ignore=shutil.ignore_patterns("cache"))
    words = f"{headline('heights.adjusted_since', {'name': 'r'})} [heights.adjusted_since]"
    for change, times in (("", 0), ("9", 1)):
        images = tmp_path / "r/block/images.csv"
        images.write_text(images.read_text().rstrip("\n") + change + "\n")
        for folder in (tmp_path / "r", tmp_path / "r/surface"):
            capsys.readouterr()
            assert main(["status", str(folder)]) == 0
            assert capsys.readouterr().out.count(f"warning: {words}") == times
    assert main(["heights", "volume", str(tmp_path / "r/surface"), "--above", "0", "--most-filled", "100"]) == 0
    assert words in capsys.readouterr().out


@pytest.mark.parametrize("state", ["without points", "without heights", "killed while it wrote", "in work"])
def test_what_is_still_needed_may_not_be_deleted(measured, tmp_path, capsys, monkeypatch, state):
    _, out = measured
    shutil.copytree(out / "work", tmp_path / "s/work", ignore=shutil.ignore_patterns("cache"))
    if state != "without points":
        shutil.copy(out / "points.ply", tmp_path / "s")
    if state in {"killed while it wrote", "in work"}:
        for path in out.glob("heights*"):
            shutil.copy(path, tmp_path / "s")
    if state == "killed while it wrote":
        settings = tmp_path / "s/work/project.toml"
        settings.write_text(re.sub(r"^dsm = .points.*\n", "", settings.read_text(), flags=re.MULTILINE))
    if state == "in work":
        monkeypatch.setattr("raybundle.pipeline.running.works", lambda _: True)
    assert main(["status", str(tmp_path / "s")]) == 0
    stated = capsys.readouterr().out
    assert "fusion" in stated
    assert f"{tmp_path / 's/work'} " not in stated


def test_packages_that_are_missing_are_told_at_once(half, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("raybundle.io.raster_library.found_raster_library", lambda: None)
    monkeypatch.setattr("raybundle.report.paper.needed.find_spec", lambda _: None)
    words = ["surface", str(half / "block"), "--photos", str(half), "--out", str(tmp_path / "s"), "--pdf"]
    assert main([*words, "--dsm", "0.1", "--ortho", "0.1"]) == 2
    told = capsys.readouterr().err
    assert told.count("raybundle[geo]") == told.count("raybundle[pdf]") == 1
    assert not (tmp_path / "s").exists()


def test_an_interrupted_run_says_what_is_kept(half, warned, tmp_path, capsys, monkeypatch):
    def stopped(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("raybundle.cli.surface.run_surface", stopped)
    assert main(["surface", str(warned), "--photos", str(half), "--out", str(tmp_path / "s")]) == 130
    assert str(tmp_path / "s/work") in capsys.readouterr().err


def test_points_beside_the_area_of_the_heights_are_counted_with_the_extent_that_holds_them(measured):
    done = measured[0].surface
    whole = done.heights.grid
    few = replace(whole, grid=whole.grid.part(10, 10, whole.grid.width // 4, whole.grid.height // 4))
    outside, area = area_of_points(done, few)
    assert 0.5 < outside / len(done) < 1
    wide = grid_over(area, whole.grid.pixel)
    lost, _ = area_of_points(done, replace(whole, grid=wide))
    assert lost < 0.01 * len(done)
    with reading(COMMAND_LINE):
        (told,) = outside_words(done_with(done, few), Grids(heights=few))
    assert f"{outside // 1000}" in told
    assert f"--extent {area[0]:.6g}"[:12] in told


def done_with(done, grid):
    """The surface as if it had these heights."""
    return replace(done, heights=replace(done.heights, grid=grid))


def test_the_page_in_print(half, warned, tmp_path):
    pytest.importorskip("typst")
    pypdf = pytest.importorskip("pypdf")
    done = command.surface(warned, tmp_path / "s", photos=(half,), density="4", jobs=1, pdf=True,
                           extent=(-0.2, -0.2, 0.2, 0.2))  # fmt: skip
    assert tmp_path / "s/surface.pdf" in done.pages.files
    text = "".join(p.extract_text() for p in pypdf.PdfReader(tmp_path / "s/surface.pdf").pages)
    assert "North front" in text
    assert " ".join(headline("front.faults", {"n": 1}).split()) in " ".join(text.split())


@pytest.mark.parametrize("shares", [(0.55, 0.29, 0.16), (1 / 3, 1 / 3, 1 / 3), (0.005, 0.99, 0.005), (1.0, 0.0, 0.0)])
def test_shares_are_a_hundred_together(shares):
    assert sum(whole_shares(shares)) == 100
    assert all(abs(100 * s - n) < 1 for s, n in zip(shares, whole_shares(shares), strict=True))


def test_the_report_of_a_result_names_the_dense_points_beside_it(half, tmp_path):
    adjusted = rb.adjust(read_block(half / "block"))
    write_result(adjusted, tmp_path / "result")
    name = "../surface/surface.html"
    assert name not in (tmp_path / "result/report.html").read_text()
    (tmp_path / "surface").mkdir()
    (tmp_path / "surface/surface.html").write_text("dense")
    for language in ("en", "de"):
        write_result(adjusted, tmp_path / "result", language=language)
        words = headline("front.dense_points", {"file_name": name}, Reader(language))
        assert words in (tmp_path / "result/report.html").read_text()


@pytest.mark.parametrize(
    ("system", "compound"),
    [("EPSG:25832+7837", True), ("EPSG:32633+ellipsoid", False), ("EPSG:32633", None), ("EPSG:4326", None)],
)
def test_what_heights_of_a_map_count_from_is_known_where_its_system_says_it(system, compound):
    found = system_with_heights(system)
    assert (None if found is None else found.is_compound) == compound
    if found is not None:
        assert len(found.axis_info) == 3
