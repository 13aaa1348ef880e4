"""Stages run from the page: the settings of the command, progress, stop, what is kept, the desk with the new result."""

import shlex
import signal
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import pytest

from raybundle.commands.orient import OrientSettings, orient, settings_asked
from raybundle.errors import InputError, message
from raybundle.pipeline.project import Project
from raybundle.results.folder import read_result
from raybundle.settings import settings_of
from raybundle.studio.child import Child
from raybundle.studio.forms import settings_of_form
from raybundle.words import COMMAND_LINE
from tests.barriers import wait_for
from tests.studio.test_app import act


def until(client, wanted):
    """The run as the page gets it, as soon as something of it is so."""

    def reported():
        run = client.get("/api/run").json()["run"]
        return run if wanted(run) else None

    return wait_for(reported, "the run is as wanted")


def chosen(client, **values):
    return client.post("/api/run/settings", json={"values": values})


def test_the_form_is_the_data_class_with_what_was_asked_for(client, project):
    found = client.get("/api/run").json()
    assert found["why"] == ""
    fields = {f["name"]: f for f in found["form"]["fields"]}
    assert [*fields] == ["photos", *(s.name for s in settings_of(OrientSettings))]
    assert (fields["precise"]["flag"], fields["precise"]["value"]) == ("--quick", True)
    assert (fields["report"]["value"], fields["library"]["value"]) == (True, False)
    assert fields["photos"]["value"].count(".jpg") == 5
    assert shlex.split(found["form"]["command"])[:5] == ["raybundle", "orient", "--quick", "--no-report", "--out"]
    assert settings_asked(project).precise is False


def test_settings_are_those_of_the_command_line(client, project, studio):
    values = {
        "photos": "'a b' c.jpg", "control": "one.csv 'two b.csv'", "scale_bar": "A B 1.5 0.001 C 'D 1' 2 0.002",
        "control_sigma": "0.01 0.02", "crs": "EPSG:32633", "start": "growing", "gps": True, "jobs": 2,
        "read_out": None,
    }  # fmt: skip
    answer = chosen(client, **values)
    assert answer.status_code == 200
    assert shlex.split(answer.json()["form"]["command"]) == [
        "raybundle", "orient", "--crs", "EPSG:32633", "--start", "growing", "--jobs", "2",
        "--control", "one.csv", "--control", "two b.csv", "--control-sigma", "0.01", "0.02",
        "--scale-bar", "A", "B", "1.5", "0.001", "--scale-bar", "C", "D 1", "2.0", "0.002",
        "--no-gps", "--out", str(project), "--", "a b", "c.jpg",
    ]  # fmt: skip
    assert studio.running.chosen.settings.gps is False
    fields = {f["name"]: f["value"] for f in answer.json()["form"]["fields"]}
    assert {k: fields[k] for k in values if k != "scale_bar"} == {k: values[k] for k in values if k != "scale_bar"}


@pytest.mark.parametrize(
    ("values", "code", "names"),
    [
        ({"feature_count": 3}, "setting.too_small", ("feature_count", "3", "100")),
        ({"start": "now"}, "setting.not_one_of", ("start", "now")),
        ({"scale_bar": "A B 1.5"}, "setting.word_count", ("scale_bar", "1.5", "LENGTH")),
        ({"scale_bar": "A B one 0.1"}, "setting.word_count", ("scale_bar", "0.1", "4", "LENGTH")),
        ({"control": "'open"}, "setting.quotation_open", ("control", "'open")),
        ({"photos": " "}, "studio.no_photographs", ()),
        ({"photos": ["a"]}, "setting.no_text", ("photos",)),
        ({"gps": "yes"}, "setting.wrong_kind", ("gps", "yes")),
        ({"out": "/elsewhere"}, "setting.unknown", ("out",)),
    ],
)
def test_settings_that_cannot_be_are_refused_by_name(client, studio, values, code, names):
    before = studio.running.what()
    answer = chosen(client, **values)
    assert answer.status_code == 409
    assert answer.json()["code"] == code
    assert all(name in answer.json()["error"] for name in names)
    assert studio.running.chosen == before


def test_settings_that_are_no_table(client):
    assert client.post("/api/run/settings", json={"values": 3}).status_code == 400


def test_two_values_are_two_words():
    with pytest.raises(InputError, match=r"2.*setting\.word_count"):
        settings_of_form(OrientSettings, {"control_sigma": "1 2 3"}, {"photos": (), "out": "x"})


@pytest.mark.long
def test_run_stop_run_again(client, studio, project, tmp_path):
    """Stopped in the middle, the project is readable and goes on; the end is what the command makes; marks stay."""
    photos = sorted((project.parent / "photos").glob("*.jpg"))[:4]
    act(client, "put", image="portal_02.jpg", point="gate", x_px=800.0, y_px=600.0)
    folder = str(project.parent / "photos")
    names = " ".join(f"'{folder}/{p.name}'" for p in photos)
    assert chosen(client, photos=names, precise=True, feature_count=2000).status_code == 200
    begun = client.post("/api/run", json={}).json()["run"]
    assert begun["outcome"] == "running"
    assert client.post("/api/run", json={}).status_code == 409
    assert client.post("/api/adjust", json={}).json() == {"begun": False}
    until(client, lambda r: any(s["state"] in {"done", "kept"} for s in r["stages"]))
    assert client.post("/api/stop", json={}).json() == {"stopping": True}
    stopped = until(client, lambda r: r["outcome"] != "running")
    assert (stopped["outcome"], stopped["words"]) == ("stopped", "")
    kept = {s["title"] for s in stopped["stages"] if s["state"] in {"done", "kept"}}
    opened = Project.open(project, create=False)
    assert kept <= {r.name for r in opened.stages()}
    opened.close()
    assert read_result(project / "result").block.images.ids  # the one before, whole
    before = client.get("/api/overview").json()["times"]
    client.post("/api/run", json={})
    done = until(client, lambda r: r["outcome"] != "running")
    assert (done["outcome"], [s["state"] for s in done["stages"]][-1]) == ("done", "done")
    assert done["stages"][0]["title"] in kept
    assert "4 of 4 photographs" in done["words"]
    studio.work.wait()
    overview = client.get("/api/overview").json()
    assert overview["times"] == before + 1
    assert [m["point"] for m in overview["state"]["marks"]] == ["gate"]
    assert client.get("/api/adjustments").json()["adjustments"][-1]["origin"] == "oriented"
    orient(photos, tmp_path / "same", feature_count=2000, precise=False, report=False)
    ours, theirs = (read_result(p / "result") for p in (project, tmp_path / "same"))
    for name in ("sigma0", "redundancy", "observations"):
        assert ours.result[name] == pytest.approx(theirs.result[name], rel=1e-12)


@pytest.fixture(params=["in front", "in the background"])
def interrupts(request):
    """A studio at the terminal, and one begun by `&`: an interrupt before a child listens is lost."""
    before = signal.getsignal(signal.SIGINT)
    signal.signal(signal.SIGINT, signal.SIG_IGN if request.param == "in the background" else signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("interrupts")
def test_a_run_ends_with_the_studio_and_at_once_where_it_is_asked_twice(client, studio, project):
    for end in (studio.running.close, lambda: (studio.running.stop(), studio.running.stop())):
        assert client.post("/api/run", json={}).status_code == 200
        end()
        studio.running.wait()
        assert studio.running.run.child.process.poll() is not None
        assert client.get("/api/run").json()["run"]["outcome"] == "stopped"
        Project.open(project).close()  # nobody holds it


@pytest.mark.usefixtures("interrupts")
def test_a_program_that_is_stopped_while_it_is_loaded_ends():
    child = Child.begin(["doctor"])
    child.stop()
    status, printed = child.follow(lambda *_: None)
    assert status
    assert not printed


def test_a_program_ends_with_a_studio_that_is_killed(project, tmp_path):
    """Its input ends then, and it stops as if interrupted; what it has finished is kept."""
    photos = [str(p) for p in sorted((project.parent / "photos").glob("*.jpg"))]
    child = Child.begin(["orient", *photos, "--out", str(tmp_path / "other"), "--progress", "json"])
    steps = []

    def progress(step, _):
        if not steps:
            child.process.stdin.close()
        steps.append(step)

    status, _ = child.follow(progress)
    assert status == 130
    assert not (tmp_path / "other" / "result").exists()


def test_nul_in_a_path_is_refused(client):
    answer = chosen(client, photos="a\0b.jpg")
    assert answer.status_code == 409
    assert answer.json()["code"] == "setting.impossible_character"


def test_a_run_that_fails_says_what_the_command_says(client, project):
    chosen(client, photos=str(project / "nowhere"))
    client.post("/api/run", json={})
    failed = until(client, lambda r: r["outcome"] != "running")
    assert failed["outcome"] == "failed"
    assert failed["words"].startswith(("InputError: ", "error: "))
    assert "nowhere" in failed["words"]
    assert client.get("/api/overview").status_code == 200


def test_nothing_runs_in_a_block(client, studio, project, monkeypatch):
    monkeypatch.setattr(studio.desk, "source", project / "result" / "block")
    found = client.get("/api/run").json()
    assert found["form"] is None
    assert found["why"] == message("studio.nothing_to_run").text(COMMAND_LINE)
    assert client.post("/api/run", json={}).status_code == 409


def test_nothing_is_adjusted_while_a_run_begins(studio):
    with ThreadPoolExecutor(1) as pool:
        asked = []
        what = SimpleNamespace(
            check=lambda: asked.append(pool.submit(studio.running.adjust)), child_words=("--version",), titles=(),
            origin=None, name="", command="", records=list,
        )  # fmt: skip
        studio.running.begin(what)
        assert asked[0].result() is False
    studio.running.wait()
    assert not studio.work.busy
