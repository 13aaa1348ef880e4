"""The page has its words from the catalogues: no sentence stands in its scripts, and every code has its entry."""

import json
import re
import shutil
import subprocess

import pytest
from starlette.testclient import TestClient

from raybundle import words
from raybundle.errors import phrase
from raybundle.studio.app import Studio, words_of_page
from raybundle.studio.guard import Session
from raybundle.studio.watchers import json_text
from raybundle.words.catalogue import entries, entry_of
from raybundle.words.render import Reader, _with
from tests.studio.conftest import BASE, PORT
from tests.studio.test_bundle import ROOT, WEB, tools

__all__ = ["tools"]  # a fixture
SCRIPTS = sorted((WEB / "studio").glob("*.ts"))
PAGE = ROOT / "src/raybundle/studio/static/index.html"
TOKEN = re.compile(
    r"""//[^\n]*|/\*.*?\*/|(?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\.|[^`\\])*`)|/(?![/*\s])(?:\\.|[^/\n])+/""",
    re.DOTALL,
)
CLASSES = re.compile(r"""class: (?:"[^"]*"|`[^`]*`)""")
WORDS = re.compile(r"[A-Za-z]{2,}[,:;.]? +[A-Za-z]{2,}")
ALLOWED = re.compile(r"""
    (600\ )?1[2-5](\.5)?px\ system-ui.*   # a font
  | ctrl\ shift\ z | ctrl\ z | ctrl\ y    # keys as the page names them
  | at\ work | not\ needed                # states of a stage, as the server sends them
  | not\ determinable
  | section-place\ section-thickness      # elements that show one value
  | raybundle\ studio                      # its name
""", re.VERBOSE)  # fmt: skip
CODE = re.compile(r"""["'](studio_\w+\.\w+|label\.\w+)["']""")
CALL = re.compile(r"""\b(?:say|act|button)\((?:[^()"]*, )?"(studio_\w+\.\w+)", (?=\{)""")
LANGUAGES = ("en", "de")
GERMAN = Reader("de", flags=True)
RENDERER = """
const [language, resource, wanted] = JSON.parse(require("fs").readFileSync(0, "utf-8"));
globalThis.document = {
  documentElement: { lang: language }, getElementById: () => ({ textContent: resource }), querySelectorAll: () => [],
};
const { say, titleOf } = require(process.argv[2]);
process.stdout.write(JSON.stringify(wanted.map(([code, values]) => [say(code, values), titleOf(code, values)])));
"""


def literals(source):
    """Texts of a script, outside comments and patterns; without what stands in for values."""
    source = CLASSES.sub("", source)
    return [re.sub(r"\$\{[^{}]*\}", "", m["text"][1:-1]) for m in TOKEN.finditer(source) if m["text"]]


def sentences(source):
    return [text for text in literals(source) if WORDS.search(text) and not ALLOWED.fullmatch(text)]


def test_no_script_holds_words():
    found = {p.name: texts for p in SCRIPTS if (texts := sentences(p.read_text(encoding="utf-8")))}
    assert not found, "give them a code, and words in raybundle/words/*/texts/studio_*.ftl"


@pytest.mark.parametrize("line", ['say("No point is chosen.")', "h(`${n} marks made by hand`)", "x = 'your name'"])
def test_words_in_a_script_would_be_noticed(line):
    assert sentences(line)
    assert not sentences(f"// {line}")


def test_the_page_itself_holds_no_words():
    body = re.sub(r"<head>.*?</head>|<[^>]*>", " ", PAGE.read_text(encoding="utf-8"), flags=re.DOTALL)
    assert body.split() == ["raybundle", "studio", "?", "–"]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_code_of_the_page_has_words(language):
    used = {c for p in (*SCRIPTS, PAGE) for c in CODE.findall(p.read_text(encoding="utf-8"))}
    assert len(used) > 300
    assert not [c for c in used if entry_of(c) not in entries(language)]


def test_every_call_gives_the_values_that_its_words_need():
    wrong = []
    for path in SCRIPTS:
        source = path.read_text(encoding="utf-8")
        for call in CALL.finditer(source):
            given = source[call.end() : source.index("}", call.end())]
            lacking = [n for n in words.examples(call[1]) if not re.search(rf"\b{n}\b", given) and "..." not in given]
            wrong += [f"{path.name}: {call[1]} lacks {name}" for name in lacking]
    assert not wrong


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_page_words_are_those_of_the_server(tools, language, tmp_path):
    """Fluent of JavaScript and of Python make the same of each entry, numbers and plurals included."""
    bundle = [tools / "esbuild", "studio/words.ts", "--bundle", "--format=cjs", f"--outfile={tmp_path / 'words.js'}"]
    subprocess.run([*bundle, "--log-level=error"], cwd=WEB, check=True)
    (tmp_path / "render.js").write_text(RENDERER, encoding="utf-8")
    codes = [c for c in words.text_codes() if c.startswith("studio_")]
    given = [language, words_of_page(language), [(c, words.examples(c)) for c in codes]]
    node = [shutil.which("node"), tmp_path / "render.js", tmp_path / "words.js"]
    out = subprocess.run(node, input=json.dumps(given), capture_output=True, text=True, check=True).stdout
    assert [t.replace("\u202f", " ") for t, _ in json.loads(out)] == [
        words.sentences(c, words.examples(c), Reader(language, flags=True)) for c in codes
    ]
    for code, (_, title) in zip(codes, json.loads(out), strict=True):
        message = _with(language, entry_of(code), flags=True).get_message(entry_of(code))
        assert bool(title) == ("title" in message.attributes)


def test_texts_are_sent_in_the_readers_language():
    sent = json_text({"rows": [{"why": phrase("studio_page.stopped")}, 1, None, "x"]}, GERMAN)
    assert json.loads(sent) == {"rows": [{"why": words.headline("studio_page.stopped", {}, GERMAN)}, 1, None, "x"]}


def test_a_studio_in_german(desk):
    studio = Studio.of(desk, Session(port=PORT, reader=GERMAN))
    with TestClient(studio.app(), base_url=BASE) as client:
        code = "studio_page.no_session"
        assert client.get("/").json() == {"error": words.sentences(code, {}, GERMAN), "code": code}
        page = client.get("/", params={"token": studio.session.token}).text
        assert '<html lang="de">' in page
        assert words_of_page("de") in page
        (line,) = client.get("/api/standing").json()["line"]
        assert line == words.headline("measuring.oriented", {"n": 5, "of": 5}, GERMAN)
        refused = client.post("/api/options", json={"values": {"jobs": -1}}).json()
        assert refused["code"] == "setting.too_small"


def test_a_code_without_words_is_shown_itself(tools, tmp_path):
    bundle = [tools / "esbuild", "studio/words.ts", "--bundle", "--format=cjs", f"--outfile={tmp_path / 'words.js'}"]
    subprocess.run([*bundle, "--log-level=error"], cwd=WEB, check=True)
    (tmp_path / "render.js").write_text(RENDERER, encoding="utf-8")
    given = json.dumps(["de", words_of_page("de"), [["studio_page.nowhere", {}]]])
    node = [shutil.which("node"), tmp_path / "render.js", tmp_path / "words.js"]
    out = subprocess.run(node, input=given, capture_output=True, text=True, check=True).stdout
    assert json.loads(out) == [["studio_page.nowhere", ""]]
