"""The recording sheet of a project: written, shown, kept over runs, handed over with what is made of the result."""

import re
import tomllib

import ezdxf
import pytest
from PIL import Image
from tests.cli.reported import codes_of, reported

import raybundle as rb
from raybundle import adjust
from raybundle.cli.main import main
from raybundle.commands.orient import OrientSettings, keep_settings, settings_asked
from raybundle.errors import InputError
from raybundle.io.pictures.rectified import Rectified
from raybundle.planning.simulate import Survey, simulate
from raybundle.planning.synthetic_networks import TargetField, field_scene
from raybundle.report.facts import PhotoFact, PhotographFacts
from raybundle.report.write import write_result
from raybundle.results.folder import check_target
from raybundle.results.record import NAMES, Record
from raybundle.words import headline

HOSTILE = 'a "b" \\ \n[orient]\nphotos = ["x"] \x00 <script>alert(1)</script> \u202e ü Ω \ud800'


@pytest.fixture
def project(tmp_path):
    """A project folder as `orient` begins it, with a result."""
    folder = tmp_path / "project"
    keep_settings(OrientSettings(photos=(tmp_path / "photos",), out=folder))
    return folder


def result_in(project, record=None):
    block = simulate(field_scene(TargetField(stations=4)), Survey(image_sigma_px=0.1)).observed
    camera = block.cameras[0].id
    photographs = tuple(
        PhotoFact(
            name=i, camera=camera, width_px=9, height_px=9, taken=f"2026-05-0{1 + k % 2} 12:00", device="Müller M1"
        )
        for k, i in enumerate(block.images.ids)
    )
    facts = PhotographFacts(photographs=photographs, cameras=())
    write_result(adjust(block), project / "result", report="html", photographs=facts, record=record)


def test_a_record_begins_a_project_that_orient_goes_on_with(tmp_path, capsys):
    folder = tmp_path / "begun"
    assert main(["record", str(folder)]) == 2
    printed = capsys.readouterr().err
    assert "--object NAME" in printed
    assert "--new" in printed
    assert main(["record", str(folder), "--object", "Portal"]) == 2
    assert not folder.exists()
    found = reported(capsys, "record", folder, "--new", "--object", "Portal", "--client", "Monument office")
    assert (found["next"]["code"], found["next"]["values"]) == ("record.next", {"oriented": False})
    keep_settings(OrientSettings(photos=(tmp_path / "photos",), out=folder, title="Front"))
    assert rb.record(folder).record == Record(object="Portal", client="Monument office")
    assert settings_asked(folder).title == "Front"
    assert main(["status", str(folder)]) == 0


@pytest.mark.parametrize("what", ["file", "folder"])
def test_a_record_is_not_put_into_what_is_no_project(tmp_path, capsys, what):
    other = tmp_path / "other"
    if what == "file":
        other.write_text("mine")
    else:
        other.mkdir()
        (other / "mine.txt").write_text("mine")
    assert main(["record", str(other), "--object", "Portal"]) == 2
    assert "[project.not_a_project]" in capsys.readouterr().err
    assert not (other / "project.toml").exists()


def test_a_begun_record_alone_has_a_status(tmp_path, capsys):
    assert main(["record", str(tmp_path / "begun"), "--new", "--object", "Portal"]) == 0
    capsys.readouterr()
    assert main(["status", str(tmp_path / "begun")]) in {0, 2}
    assert "internal error" not in capsys.readouterr().err


def test_it_is_written_and_shown(project, capsys):
    assert codes_of(reported(capsys, "record", project), ["summary"]) == ["record.empty"]
    assert main(["record", str(project), "--client", "Denkmalamt Göttingen", "--place", "Ελλάδα"]) == 0
    assert main(["record", str(project), "--object", "Portal"]) == 0
    capsys.readouterr()
    assert main(["record", str(project)]) == 0
    told = capsys.readouterr().out
    assert ["client", "Denkmalamt", "Göttingen"] in [line.split() for line in told.splitlines()]
    assert re.search(r"object +Portal", told)
    assert main(["record", str(project), "--client", ""]) == 0
    assert rb.record(project).record == Record(object="Portal", place="Ελλάδα")


def test_a_mistyped_project_is_refused_with_the_one_that_is_meant(project, capsys):
    wrong = project.with_name("projet")
    assert main(["record", str(wrong), "--client", "x"]) == 2
    told = capsys.readouterr().err
    assert f"whether {project} is meant" in " ".join(told.split())
    assert not wrong.exists()


def test_comments_and_order_of_the_table_stay(project):
    file = project / "project.toml"
    mine = """# who and what
[record]
# by hand, 3 May
client = "Amt"  # see letter
place = \"\"\"
Market # 3,
Göttingen\"\"\"

# the object
object = 'Portal'

[office]
folder = 12
"""
    before = file.read_text()
    file.write_text(f"{mine}\n{before}", encoding="utf-8")
    rb.record(project, client="Office", rights="CC BY 4.0")
    text = file.read_text(encoding="utf-8")
    changed = mine.replace('"Amt"', '"Office"').replace("'Portal'\n", "'Portal'\nrights = \"CC BY 4.0\"\n")
    assert text.startswith(changed)
    rb.record(project, object="", place="Leer")
    told = tomllib.loads(file.read_text(encoding="utf-8"))
    assert told["record"] == {"client": "Office", "place": "Leer", "rights": "CC BY 4.0"}
    for line in ("# who and what", "# by hand, 3 May", "# see letter", "# the object"):
        assert line in file.read_text(encoding="utf-8")


def test_how_control_was_measured_has_the_name_of_its_entry_too(project):
    assert main(["record", str(project), "--control", "total station"]) == 0
    assert rb.record(project).record == Record(control="total station")
    assert main(["record", str(project), "--georeferencing", "tape"]) == 0
    assert rb.record(project).record == Record(control="tape")


def test_every_entry_can_be_written(project):
    entries = {name: f"{name} ä" for name in NAMES}
    rb.record(project, **entries)
    assert rb.record(project).record == Record(**entries)


def test_a_run_keeps_the_record_and_what_was_edited_by_hand(project, tmp_path):
    rb.record(project, client="Amt")
    file = project / "project.toml"
    mine = '[record]\n# by hand\nclient = "Amt"\ndescription = """\nTwo\n[table]\n"""\nreference = 4711\n'
    other = "\n# of another program\n[office]\nfolder = 12\n\n[office.inner]\nx = 1\n"
    file.write_text(file.read_text().split("[record]")[0] + mine + other)
    for title in ("one", "two"):
        keep_settings(OrientSettings(photos=(tmp_path / "photos",), out=project, title=title))
        text = file.read_text()
        assert mine.strip() in text
        assert other[:30] in text
        assert text.count("[orient]") == text.count("[record]") == 1
        assert tomllib.loads(text)["office"] == {"folder": 12, "inner": {"x": 1}}
        assert settings_asked(project).title == title
    assert rb.record(project).record == Record(client="Amt", description="Two\n[table]", reference="4711")


def test_hostile_entries_stay_entries(project):
    for name in ("object", "description"):
        rb.record(project, **{name: HOSTILE})
    told = tomllib.loads((project / "project.toml").read_text(encoding="utf-8"))
    assert set(told) == {"orient", "record"}
    assert "\x00" not in told["record"]["object"]
    assert "ü Ω" in told["record"]["object"]
    result_in(project, rb.record(project).record)
    page = (project / "result/report.html").read_text(encoding="utf-8")
    assert "<script>alert(1)</script>" not in page
    assert "alert(1)" in page


@pytest.mark.parametrize(
    ("text", "told"),
    [("[record]\nclinet = 'x'\n", r"record\.unknown_entry"), ("[record]\nclient = [1]\n", r"record\.not_a_text"),
     ("[record\n", "project.toml")],
)  # fmt: skip
def test_a_file_that_was_edited_wrongly_is_told_and_kept(project, tmp_path, text, told):
    file = project / "project.toml"
    file.write_text(text)
    with pytest.raises(InputError, match=told):
        rb.record(project, place="x")
    assert file.read_text() == text
    with pytest.raises(InputError, match=told):
        rb.orient(tmp_path / "photos", project)
    assert file.read_text() == text


def test_what_is_no_project_has_no_record(tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(InputError, match=r"project\.not_a_project"):
        rb.record(tmp_path, client="x")
    keep_settings(OrientSettings(photos=(tmp_path,), out=tmp_path / "p"))
    with pytest.raises(InputError, match=r"record\.too_long"):
        rb.record(tmp_path / "p", description="x" * 20_000)


def test_it_goes_with_the_result(project, tmp_path):
    rb.record(project, object="Bürgerhaus", conditions="overcast", rights="© Büro", operator="Weiß")
    result_in(project, rb.record(project).record)
    told = tomllib.loads((project / "result/record.toml").read_text(encoding="utf-8"))
    assert told["record"]["object"] == "Bürgerhaus"
    assert told["photographs"]["first"] == "2026-05-01"
    assert told["photographs"]["last"] == "2026-05-02"
    assert told["photographs"]["cameras"][0].startswith("Müller M1, ")
    page = (project / "result/report.html").read_text(encoding="utf-8")
    entries = ("title", "sources", "from_photographs")
    for words in ("overcast", *(headline(f"report_record.{name}", {}) for name in entries)):
        assert words in page
    rb.record(project, place="Göttingen")  # the result is told at once, its report with the next run
    told = tomllib.loads((project / "result/record.toml").read_text(encoding="utf-8"))
    assert told["record"]["place"] == "Göttingen"
    assert told["photographs"]["first"] == "2026-05-01"
    check_target(project / "result")  # another run may replace it
    rb.convert(project, tmp_path / "p.dxf", to="dxf", free_scale=True)
    kept = ezdxf.readfile(tmp_path / "p.dxf").header.custom_vars
    assert kept.get("object") == "Bürgerhaus"
    assert kept.get("rights") == "© Büro"


@pytest.mark.parametrize("suffix", [".tif", ".jpg"])
def test_pictures_have_it_in_their_tags(tmp_path, suffix):
    picture = Rectified.empty(20, 30)
    record = {"object": "Bürgerhaus", "operator": "Weiß", "rights": "© Büro", "place": "Göttingen"}
    picture.write(tmp_path / f"a{suffix}", left=0, top=0, pixel=1, about={}, record=record)
    with Image.open(tmp_path / f"a{suffix}") as written:
        tags = written.getexif()
    told = {number: tags[number].encode("latin-1").decode() for number in (270, 315, 33432)}
    assert told == {270: "Bürgerhaus; Göttingen", 315: "Weiß", 33432: "© Büro"}
