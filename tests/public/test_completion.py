"""Functions that take settings show them as keywords: to type checkers, editors, `inspect` and the reference pages."""

import ast
import inspect
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

import raybundle as rb
from raybundle.commands.orient import OrientSettings
from raybundle.settings import accepted, keywords, made, settings_of

SOURCE = Path(rb.__file__).parents[1]
OPEN = {"mark"}
"""Functions with keywords of no settings class: those of `mark` depend on the verb"""
FUNCTIONS = {n: f for n in rb.__all__ if inspect.isfunction(f := getattr(rb, n))}
RIGHT = [
    'rb.orient("photos", "out", control="gcp.csv", crs="EPSG:32633")',
    'rb.orient([Path("a.jpg"), "b.jpg"], Path("out"), control=["a.csv", Path("b.csv")], control_sigma=[0.01, 0.02])',
    'rb.orient("photos", "out", scale_bar=[["1", "2", 1.0, 1e-5]], jobs=2, noise="white", library=False)',
    'rb.measure("photos", "out", scale_bar=[("1", "2", 1.0, 1e-5), ("3", "4", 2, 1e-5)])',
    'rb.query("out", distance=("1", "2"), coordinates="1,2").copy()',
    'rb.query("out", angle=[("1", "2", "3")], plane=["1", "2", "3", "4"])',
    'rb.adjust_marks("out", datum="inner", statistics=False)[0].sigma0.is_integer()',
    'rb.calibrate_zoom(["a", "b"], "zoom", focal=(24.0, 35.0), keep=True)',
    'rb.choose_targets("aicon14", count=20)',
    'rb.rectify("out", "facade.tif", pixel=0.002, photos="a.jpg", axis=("A", "B"), progress=print)',
]
WRONG = [
    'rb.orient("photos", "out", controll="gcp.csv")',
    'rb.orient("photos", "out", control=3)',
    'rb.orient("photos", "out", control=[1, 2])',
    'rb.orient("photos", "out", control_sigma=(0.01, 0.02, 0.03))',
    'rb.orient("photos", "out", noise="grey")',
    'rb.orient("photos", "out", jobs="all")',
    'rb.orient("photos", "out", jobs=2.5)',
    'rb.orient("photos", "out", library="no")',
    'rb.orient("photos", "out", crs=32633)',
    'rb.orient("photos", "out", scale_bar=[("1", "2", 1.0)])',
    'rb.orient("photos", "out", "gcp.csv")',
    'rb.orient("photos", control="gcp.csv")',
    'rb.calibrate("board", "out", targets="chessboard-9x6")',
    'rb.convert("out", "model", to=3)',
    'rb.convert("out", "model")',
    'rb.query("out", distance=("1", "2", "3"))',
    'rb.adjust_marks("out", datum="iner")',
    'rb.rpc_ortho("scene.tif", "dem.tif", crs="EPSG:32654", resampling="linear")',
    'rb.plan_network("box:4,3,2", "out", format="6000x4000")',
    'rb.orient("photos", "out").orientated',
]


def test_a_type_checker_accepts_right_calls_and_finds_wrong_ones(tmp_path):
    pytest.importorskip("basedpyright")
    script = ["from pathlib import Path", "", "import raybundle as rb", "", *RIGHT, *WRONG]
    (tmp_path / "script.py").write_text("\n".join(script) + "\n", encoding="utf-8")
    (tmp_path / "pyrightconfig.json").write_text(
        json.dumps({
            "typeCheckingMode": "standard", "pythonVersion": "3.11", "include": ["script.py"],
            "extraPaths": [str(SOURCE)],
        })
    )  # fmt: skip
    done = subprocess.run(
        [sys.executable, "-m", "basedpyright", "--pythonpath", sys.executable, "--outputjson", "--level", "error",
         "-p", str(tmp_path)], capture_output=True, text=True, check=False,
    )  # fmt: skip
    found = json.loads(done.stdout)["generalDiagnostics"]
    lines = {m["range"]["start"]["line"] for m in found if m["severity"] == "error"}
    assert {script[line] for line in lines} == set(WRONG), [m["message"] for m in found]
    assert len(lines) == len(WRONG) == 2 * len(RIGHT) == 20


def test_signatures_have_the_names_of_the_settings():
    parameters = inspect.signature(rb.orient).parameters
    assert [*parameters] == ["photos", "out", "progress", *(s.name for s in settings_of(OrientSettings))]
    assert parameters["control"].kind is inspect.Parameter.KEYWORD_ONLY
    assert parameters["control"].annotation == "str | Path | Sequence[str | Path]"
    assert parameters["feature_count"].default == OrientSettings(photos=(), out=Path()).feature_count
    assert (rb.orient.__doc__ or "").startswith("Orient photographs")
    assert [*inspect.signature(rb.plan_next).parameters].count("photographs") == 1


def test_every_function_that_takes_settings_shows_them():
    catching = {n for n, f in FUNCTIONS.items() if "**" in str(inspect.signature(f))}
    assert catching == OPEN
    with_settings = {n for n, f in FUNCTIONS.items() if hasattr(f, "settings")}
    by_code = {n for n, f in FUNCTIONS.items() if inspect.unwrap(f).__code__.co_flags & inspect.CO_VARKEYWORDS}
    assert with_settings == by_code - OPEN
    assert len(with_settings) > 30


def test_the_stub_has_every_public_name():
    tree = ast.parse((SOURCE / "raybundle/__init__.pyi").read_text(encoding="utf-8")).body
    functions = {n.name: n for n in tree if isinstance(n, ast.FunctionDef)}
    imported = {a.asname for n in tree if isinstance(n, ast.ImportFrom) for a in n.names} - {None}
    assert functions.keys() | imported | {"__version__"} == set(rb.__all__)
    assert functions.keys() == {n for n, f in FUNCTIONS.items() if hasattr(f, "settings")}
    for name, function in functions.items():
        a = function.args
        assert [x.arg for x in [*a.args, *a.kwonlyargs]] == [*inspect.signature(FUNCTIONS[name]).parameters]
        assert (FUNCTIONS[name].__doc__ or "").split("\n")[0] in (ast.get_docstring(function) or "")


def test_a_parameter_of_the_function_is_not_repeated():
    @keywords(OrientSettings)
    def own(photos: str, out: str, *, jobs: str = "one", **settings: object) -> None:
        """Nothing."""

    signature = inspect.signature(own)
    assert signature.parameters["jobs"].default == "one"
    assert "crs" in signature.parameters
    assert "settings" not in signature.parameters


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        (bool, "bool"),
        (float | None, "float | None"),
        (Path | None, "str | Path | None"),
        (tuple[str, ...], "str | Sequence[str]"),
        (tuple[float, ...], "float | Sequence[float]"),
        (tuple[int, int], "tuple[int, int] | list[int]"),
        (tuple[tuple[str, str], ...], "Sequence[tuple[str, str] | list[str]]"),
    ],
)
def test_types_are_widened_as_values_are(kind, words):
    assert accepted(kind) == words


def test_one_value_stands_for_a_tuple_of_one():
    assert made(rb.ZoomSettings, {"results": (), "out": "a", "focal": 24}).focal == (24.0,)
    assert made(rb.OrientSettings, {"photos": (), "out": Path(), "control": "a.csv"}).control == (Path("a.csv"),)


def test_docstrings_name_existing_keywords():
    calls = [(n, f"{n}({a})") for n, a in re.findall(r"rb\.(\w+)\((.*)\)", rb.__doc__)]
    assert {"orient", "film", "rpc_correct"} <= {n for n, _ in calls}
    wrong = [
        (name, keyword.arg)
        for name, call in calls
        if name in FUNCTIONS
        for keyword in ast.parse(call, mode="eval").body.keywords
        if keyword.arg not in inspect.signature(FUNCTIONS[name]).parameters
    ]
    wrong += [
        (name, keyword)
        for name, function in FUNCTIONS.items()
        if hasattr(function, "settings")
        for keyword in re.findall(r'\b(\w+)=["(\d]', function.__doc__ or "")
        if keyword not in inspect.signature(function).parameters
    ]
    assert wrong == []
