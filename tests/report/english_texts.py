"""English texts that can reach the reader of a report, found in the source: templates with {} for each place."""

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import raybundle

SOURCE = Path(raybundle.__file__).parent
WORD = re.compile(r"[A-Za-z]{2}")
SILENT_CALLS = {
    "option", "compile", "sub", "split", "fullmatch", "search", "findall", "match", "import_module", "getattr",
    "get_template", "PackageLoader", "files", "encode", "decode", "write_text", "read_text", "strftime", "startswith",
    "endswith", "partition", "einsum", "argsort", "quantile", "setting", "TypeVar", "assert_never", "isinstance",
    "astype", "searchsorted", "removeprefix", "removesuffix", "write_table", "meshgrid", "query", "progress",
    "InputError", "NotSolvable", "NoOrientation", "DatumDefect", "RankDefect", "TypeError", "ValueError", "KeyError",
    "chapter", "section", "get", "pop", "norm", "label_style", "stage", "with_name", "glob", "with_suffix", "line_of",
    "NoConvergence", "TooFewObservations", "fail",
}  # fmt: skip
"""Calls whose texts nobody reads: patterns, names of files and of registered things, errors"""
TOLD_ERRORS = {"Unusable"}
"""Errors that a report lists: why a file is no photograph"""
SILENT_ARGUMENTS = {
    "code", "kind", "style", "anchor", "anchors", "after", "part", "key", "encoding", "newline", "mode", "axis", "ext",
    "grade", "method", "side", "name_of", "grid", "file", "prefix", "id",
}  # fmt: skip
"""Arguments that are no words"""


@dataclass(slots=True)
class Text:
    """A text of the source."""

    template: str
    file: str
    line: int
    within: list[list["Text"]] = field(default_factory=list)
    """of each place, the texts that can stand there"""


def template_of(node: ast.expr) -> tuple[str, list[ast.expr]] | None:
    """A string expression as a template and what stands at its places; None: it is none."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value, []
    if isinstance(node, ast.JoinedStr):
        words, places = "", list[ast.expr]()
        for v in node.values:
            if isinstance(v, ast.Constant):
                words += str(v.value)
            else:
                words += "{}"
                places.append(v.value)
        return words, places
    parts = _added(node)
    if len(parts) > 1:
        made = [template_of(p) for p in parts]
        if made[0] is not None and made[-1] is not None:  # what is not literal between two texts is a place
            every = [t or ("{}", [p]) for t, p in zip(made, parts, strict=True)]
            return "".join(words for words, _ in every), [p for _, places in every for p in places]
    return None


def _added(node: ast.expr) -> list[ast.expr]:
    """The parts of a sum."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return [*_added(node.left), *_added(node.right)]
    return [node]


def _name(call: ast.Call) -> str:
    f = call.func
    return f.id if isinstance(f, ast.Name) else f.attr if isinstance(f, ast.Attribute) else ""


def texts_in(node: ast.AST, file: str) -> Iterator[Text]:
    """The texts below a node of a module."""
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return  # a docstring
    if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and _name(node.exc) in TOLD_ERRORS:
        yield from texts_in(node.exc, file)
        return
    if isinstance(node, ast.Raise | ast.Assert | ast.Import | ast.ImportFrom | ast.Compare):
        return
    if isinstance(node, ast.Subscript):
        yield from texts_in(node.value, file)
        return
    if isinstance(node, ast.AnnAssign):
        if node.value is not None:
            yield from texts_in(node.value, file)
        return
    if isinstance(node, ast.FunctionDef):
        for statement in node.body:
            yield from texts_in(statement, file)
        for default in (*node.args.defaults, *(d for d in node.args.kw_defaults if d)):
            yield from texts_in(default, file)
        return
    if isinstance(node, ast.Dict):
        for k, v in zip(node.keys, node.values, strict=True):
            if not isinstance(v, ast.Constant) and k is not None and not isinstance(k, ast.Constant):
                yield from texts_in(k, file)
            yield from texts_in(v, file)
        return
    if isinstance(node, ast.Call):
        if _name(node) in SILENT_CALLS:
            if isinstance(node.func, ast.Attribute):
                yield from texts_in(node.func.value, file)
            return
        for child in (node.func, *node.args):
            yield from texts_in(child, file)
        for k in node.keywords:
            if k.arg not in SILENT_ARGUMENTS:
                yield from texts_in(k.value, file)
        return
    if isinstance(node, ast.expr) and (found := template_of(node)) is not None:
        words, places = found
        within = [list(texts_in(p, file)) for p in places]
        if WORD.search(words.replace("{}", "")) and not silent(words):
            yield Text(words.strip(), file, node.lineno, within)
        else:
            for w in within:
                yield from w
        return
    for child in ast.iter_child_nodes(node):
        yield from texts_in(child, file)


def silent(words: str) -> bool:
    """Whether a text is none for people: markup, a path of a drawing, a name of a file or of a column."""
    w = words.strip()
    return bool(
        w.startswith(("<", "#", "/", "M{", '" '))
        or (w.startswith(".") and " " not in w)
        or re.fullmatch(r"[\w{}/.-]*[_/.][\w{}/.-]*", w)
        or re.fullmatch(r"[A-Z]+", w)
    )


def texts_of(path: Path) -> list[Text]:
    """The texts of a module."""
    return list(texts_in(ast.parse(path.read_text(encoding="utf-8")), str(path.relative_to(SOURCE))))


def flat(texts: list[Text]) -> Iterator[Text]:
    """The texts and those at their places."""
    for t in texts:
        yield t
        for w in t.within:
            yield from flat(w)
