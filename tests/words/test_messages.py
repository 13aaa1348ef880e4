"""Messages: every code has words in every language, every place that makes one gives what they need."""

import ast
import json
import re
from functools import cache
from pathlib import Path

import pytest

from raybundle import words
from raybundle.errors import InputError, Message, NoOrientation, Severity, Text, message_of
from raybundle.words import render
from raybundle.words.catalogue import code_of, entries, entry_of
from raybundle.words.render import Reader
from tests.sources import SOURCE, texts, trees

LONGEST = 100
"""Characters of a headline"""
KIN = frozenset(
    """
    InputError NotSolvable DatumDefect RankDefect TooFewObservations NoConvergence NoOrientation TasksWaiting Notice
    worded Message message note warning phrase
    """.split()  # noqa: SIM905  (read like a text)
)
RESERVED = frozenset(
    "file line column details undetermined open_names code ids reason measured severity also".split()  # noqa: SIM905
)
PAGE = SOURCE.parents[1] / "web/studio"
"""Scripts of the studio's page: they use the groups studio_... and label"""
TEXTS = 3
"""Calls that make a message of a text, as long as they are moved to catalogues: may only shrink"""
ENGLISH = Path(__file__).with_name("english.txt")
"""Modules with texts of three English words or more outside the catalogues, and how many: may only shrink"""
WORDS = re.compile(r"(?<![\w./<\\-])[A-Za-z][a-z']+(?![\w(/=>\\])")
NO_TEXT = re.compile(r"[\n<>=|\\[]|^#")
"""Code, markup, patterns and comments of files"""
HELP = frozenset("setting option _entry".split())  # noqa: SIM905
PROGRAM = frozenset("einsum cast compile search sub fullmatch TypeVar ContextVar".split())  # noqa: SIM905
PROGRAMMERS = frozenset(
    "ValueError AssertionError RuntimeError TypeError NotImplementedError KeyError ConnectionError".split()  # noqa: SIM905
)


@cache
def in_source():
    """Calls that make a message (file, name, call), and English texts of each file, from one reading of all modules."""
    made, written = [], {}
    for file, tree in trees("|".join((*KIN, r"\w+ \w+ \w+"))):
        for node in ast.walk(tree):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "id", getattr(node.func, "attr", ""))
                if name in KIN:
                    made.append((file, name, node))
        if not file.startswith(("words/", "cli/", "studio/")) and (texts_here := english(tree)):
            written[file] = texts_here
    return made, written


def calls():
    return in_source()[0]


def coded(name, node):
    """The code of a call and the names of its values; None where it has a text."""
    first = node.args[0] if node.args else None
    keywords = {k.arg: k.value for k in node.keywords if k.arg}
    if name in {"Notice", "Message"}:
        code = keywords.get("code")
        if not isinstance(code, ast.Constant) or ("message" in keywords):
            return None
        values = keywords.get("values")
        whole = isinstance(values, ast.Dict) and None not in values.keys
        keys = [k.value for k in values.keys if isinstance(k, ast.Constant)] if whole else None
        if values is not None and keys is None:
            return code.value, None
        return code.value, {*(keys or ()), *(["ids"] if "ids" in keywords else [])}
    if isinstance(first, ast.Constant) and re.fullmatch(r"[a-z]\w*\.\w+", str(first.value)):
        if name == "message" or any(k.arg is None for k in node.keywords):  # whoever takes a message may add values
            return first.value, None
        return first.value, set(keywords) - RESERVED - ({"images"} if name == "NoOrientation" else set())
    return None


def text_calls():
    """Calls that make a message of a text."""
    for file, name, node in calls():
        if name in {"Notice", "Message"}:
            if any(k.arg == "message" for k in node.keywords):
                yield f"{file}:{node.lineno}"
        elif node.args and coded(name, node) is None and name not in {"message", "note", "warning"}:
            first = node.args[0]
            if isinstance(first, ast.JoinedStr | ast.BinOp) or (
                isinstance(first, ast.Constant) and isinstance(first.value, str)
            ):
                yield f"{file}:{node.lineno}"


def test_fewer_places_make_sentences():
    left = list(text_calls())
    assert len(left) <= TEXTS, f"{len(left)} calls make a message of a text; give a code, and words in raybundle/words"
    assert len(left) == TEXTS, f"{len(left)} are left: lower TEXTS to this"


def english(tree):
    """Texts of three words or more in a tree: no docstrings, no help, nothing for programmers."""
    found, rest = [], [tree]
    while rest:
        node = rest.pop()
        text = node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None
        if isinstance(node, ast.JoinedStr):
            text = "".join(str(v.value) if isinstance(v, ast.Constant) else "{}" for v in node.values)
        match node:
            case ast.Expr(value=ast.Constant()):
                pass
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name)) if name in HELP | PROGRAM:
                pass
            case ast.Raise(exc=ast.Call(func=ast.Name(id=name))) if name in PROGRAMMERS:
                pass
            case ast.Assign(targets=[ast.Name(id=name)]) if name.endswith("HELP"):
                pass
            case ast.Subscript():  # of types
                rest.append(node.value)
            case _ if text is None:
                rest.extend(ast.iter_child_nodes(node))
            case _ if len(WORDS.findall(text)) > 2 and not NO_TEXT.search(text):
                found.append(text)
    return found


def test_fewer_modules_have_english_texts():
    found = in_source()[1]
    left = dict(line.split() for line in ENGLISH.read_text(encoding="utf-8").splitlines())
    more = [f"{m}: {t!r}" for m, own in found.items() if len(own) > int(left.get(m, 0)) for t in own]
    assert not more, "\n".join(["give a code, and words in raybundle/words:", *more])
    lower = [f"{m} {len(found.get(m, ()))}" for m, n in left.items() if len(found.get(m, ())) < int(n)]
    assert not lower, "\n".join([f"lower in {ENGLISH.name} to:", *lower])


def test_every_code_in_the_source_has_words_and_is_given_what_they_need():
    wrong = []
    for file, name, node in calls():
        found = coded(name, node)
        if found is None:
            continue
        code, given = found
        if code not in {*words.codes(), *words.text_codes()}:
            wrong.append(f"{file}:{node.lineno}: {code} is in no catalogue")
        elif given is not None and not set(words.examples(code)) <= given:
            lacking = sorted(set(words.examples(code)) - given)
            wrong.append(f"{file}:{node.lineno}: {code} lacks {', '.join(lacking)}")
    assert not wrong, "\n".join(wrong)


def test_every_code_is_used():
    page = [p.read_text(encoding="utf-8") for p in (*PAGE.glob("*.ts"), SOURCE / "studio/static/index.html")]
    used = {c for text in (*texts().values(), *page) for c in re.findall(r"[\"'](\w+(?:\.\w+)?)[\"']", text)}
    unused = [c for c in (*words.codes(), *words.text_codes()) if c not in used]
    assert not unused, f"no place makes these messages: {', '.join(unused)}"


@pytest.fixture
def parsed():
    """Forget entries afterwards that nobody else asks for: 40 MB in each language."""
    yield
    render._parsed.cache_clear()
    render._bundle.cache_clear()
    render._with.cache_clear()


@pytest.mark.parametrize("language", words.languages())
def test_every_entry_is_complete(language, parsed):
    from raybundle.words.values import Bundle

    wrong, english = [], entries(words.ENGLISH)
    for name, entry in entries(language).items():
        if name not in english:
            wrong.append(f"{entry.file}: {name} is not in English")
            continue
        if name.startswith("-"):
            continue
        for flags in (False, True) if "OPTION(" in entry.text else (False,):
            bundle = render._with(language, entry.name, flags=flags)
            assert isinstance(bundle, Bundle)
            message = bundle.get_message(name)
            parts = {"": message.value, **message.attributes}
            values = words.examples(code_of(name))
            for part, pattern in parts.items():
                text, errors = bundle.written(pattern, values)
                if errors:
                    wrong.append(f"{entry.file}: {name}{part and '.' + part}: {errors[0]}")
                if "{" in text or "$" in text:
                    wrong.append(f"{entry.file}: {name}: {text}")
                if not part and language == words.ENGLISH and len(text) > LONGEST:
                    wrong.append(f"{entry.file}: {name}: headline of {len(text)} characters: {text}")
            if set(parts) - {"", "why", "do", *(["title"] if name.startswith("studio_") else [])}:
                wrong.append(f"{entry.file}: {name}: attributes {sorted(parts)}")
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("language", [x for x in words.languages() if x != words.ENGLISH])
def test_every_message_has_a_headline_in_every_language(language):
    lacking = [c for c in words.codes() if entry_of(c) not in entries(language)]
    assert not lacking, f"{language}: {', '.join(lacking)}"


def test_no_value_is_a_sentence():
    wrong = []
    for code in words.codes():
        entry = entries(words.ENGLISH)[entry_of(code)]
        if re.search(r"=\s*\{\s*\$\w+\s*\}\s*\.?$", entry.text.splitlines()[0]):
            wrong.append(f"{code}: the headline is a value alone")
        for name, value in words.examples(code).items():
            if isinstance(value, str) and name != "detail" and len(value.split()) > 4:
                wrong.append(f"{code}: ${name} = {value!r}")
    assert not wrong, "\n".join(wrong)


def test_settings_are_named_by_a_function():
    known = re.compile("pyproj sync --file|--overwrite, in Python")  # another program; what Python does another way
    every = [e for x in words.languages() for e in entries(x).values()]
    wrong = [f"{e.file}, line {e.line}" for e in every if " --" in known.sub("", e.text)]
    assert not wrong, f'write {{ OPTION("name") }} in the place of a flag: {"; ".join(wrong)}'


def test_values_choose_words():
    text = words.headline("similarity.too_few_points", {"n": 1})
    assert text == "A similarity transformation needs three common points; 1 is given."


def test_numbers_follow_the_language():
    values = {"chosen": "x", "known": [1.5, 2.25]}
    assert "1,5; 2,25" in words.action("environment.native_unknown", values, Reader("de"))
    assert "1.5, 2.25" in words.action("environment.native_unknown", values)


def test_probabilities_follow_the_language():
    assert "(p 0,35)" in words.headline("epochs.stable_points_differ", {"p": 0.35}, Reader("de"))
    assert "(p 0.35)" in words.headline("epochs.stable_points_differ", {"p": 0.35})
    assert "(p < 1e-16)" in words.headline("epochs.stable_points_differ", {"p": 0.0}, Reader("de"))


def test_an_error_carries_its_message():
    error = InputError("outline.no_area", name="area 2", file="plan.csv", line=3)
    assert error.code == "outline.no_area"
    assert error.message == Message(code="outline.no_area", values={"name": "area 2"})
    assert str(error).startswith("plan.csv, line 3: area 2 encloses no area. ")
    assert str(error).endswith("[outline.no_area]")
    assert "umschließt keine Fläche" in error.text(Reader("de"))
    assert error.at("other.csv").file == "plan.csv"
    assert InputError("outline.no_area", name="a").at("other.csv", line=2).place.text() == "other.csv, line 2"


def test_a_message_is_data():
    detail = Message(code="mesh.no_area", values={"name": "a"})
    message = Message(code="mesh.no_triangles", values={"name": "b"}, severity=Severity.FAULT, details=(detail,))
    assert message_of(json.loads(json.dumps(message.json()))) == message
    assert message.text().count("\n") == 1


def test_a_text_is_read_in_another_language():
    text = Text.of(Message(code="outline.no_area", values={"name": "area 2"}))
    assert text.startswith("area 2 encloses no area")
    assert text.by(Reader("de")).startswith("area 2 umschließt keine Fläche")


def test_an_error_of_several_objects_lists_them():
    details = [Message(code="mesh.no_area", values={"name": n}) for n in "ab"]
    assert str(NoOrientation("similarity.points_in_line", details=details)).count("\n  Mesh") == 2


VARIANT = re.compile(r"^\s*\*?\[([\w-]+)\]|\{\s*\$(\w+)\s*->", re.MULTILINE)
PLURAL = frozenset("zero one two few many other".split())  # noqa: SIM905


def variants(entry):
    """The variant keys of an entry, without those of numbers."""
    return {k for k, _ in VARIANT.findall(entry.text) if k and k not in PLURAL and not k.isdigit()}


@pytest.mark.parametrize("language", [x for x in words.languages() if x != words.ENGLISH])
def test_variants_are_spelt_as_in_english(language):
    """A key that no value has, as [RMS] for [rms], prints the text of another variant."""
    english_ = entries(words.ENGLISH)
    wrong = []
    for name, entry in entries(language).items():
        known = variants(english_[name]) if name in english_ else set()
        more = {k for k in variants(entry) - known if k.lower() in {x.lower() for x in known}}
        wrong += [f"{entry.file}: {name}: {sorted(more)}"] if more else []
    assert not wrong, "\n".join(wrong)
