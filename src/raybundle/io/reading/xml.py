"""XML without document types and entities of its own, bounded in depth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn
from xml.parsers import expat

from raybundle.errors import InputError, Message, Value, content
from raybundle.io.reading.files import read_bytes
from raybundle.io.reading.ledger import enter_tree
from raybundle.io.reading.trees import DEEPEST
from raybundle.io.reading.words import LARGEST, no_number, number_of, numbers_of, quoted
from raybundle.numerics.arrays import Array


class Attributes(dict[str, str]):
    """The attributes of an element, which know their names that were asked for."""

    __slots__ = ("asked",)

    def __init__(self, values: Mapping[str, str]) -> None:
        super().__init__(values)
        self.asked: set[str] = set()

    def __getitem__(self, name: str) -> str:
        self.asked.add(name)
        return super().__getitem__(name)

    def get(self, name: str, default: str = "") -> str:  # type: ignore[override]
        """An attribute, or the default where there is none."""
        self.asked.add(name)
        return super().get(name, default)


@dataclass(slots=True)
class Element:
    """An XML element; unlike the rest it is filled while it is read."""

    file: Path
    line: int
    name: str
    attributes: Attributes
    children: list[Element] = field(default_factory=list["Element"])
    content: str = ""
    asked: bool = False
    """Whether a reader asked for it."""

    def fail(self, code: str | Message, /, **values: Value) -> NoReturn:
        """Raise at this element."""
        raise InputError(content(code, values), file=self.file, line=self.line, column=self.name)

    def all(self, name: str) -> Iterator[Element]:
        """Children of this name."""
        for child in self.children:
            if child.name == name:
                child.asked = True
                yield child

    def passed_over(self) -> Iterator[tuple[str, str]]:
        """Elements and attributes that were not asked for; of an element within one of these nothing is counted.

        An element of whose children none was asked for is read as a whole.
        """
        for name in self.attributes.keys() - self.attributes.asked:
            yield name, f"{name} of <{self.name}>"
        if not any(child.asked for child in self.children):
            return
        for child in self.children:
            if child.asked:
                yield from child.passed_over()
            else:
                yield child.name, f"<{child.name}>"

    def leave_out(self) -> None:
        """Count nothing within as passed over: the reader reports the whole element."""
        self.asked = True
        self.attributes.asked.update(self.attributes)
        for child in self.children:
            child.leave_out()

    def find(self, *names: str) -> Element | None:
        """The first element down this way of names."""
        found: Element | None = self
        for name in names:
            found = next(found.all(name), None) if found is not None else None
        return found

    def get(self, *names: str) -> Element:
        """The same; raises InputError where there is none."""
        found = self.find(*names)
        if found is None:
            self.fail("xml.element_missing", path="/".join(names))
        return found

    def attribute(self, name: str) -> str:
        """An attribute; raises InputError where there is none."""
        if name not in self.attributes:
            self.fail("xml.attribute_missing", name=name)
        return self.attributes[name]

    def value(self, name: str) -> float:
        """The finite number in an attribute."""
        found = number_of(self.attribute(name))
        if found is None:
            self.fail("xml.attribute_not_a_number", name=name, value=quoted(self.attribute(name)), largest=LARGEST)
        return found

    def numbers(self, count: int) -> Array:
        """(count,) finite numbers, the content."""
        words = self.content.split()
        values = numbers_of(words)
        if values is None:
            bad = next(w for w in words if number_of(w) is None)
            self.fail(no_number(bad))
        if len(values) != count:
            self.fail("value.count", n=len(values), needed=count)
        return values

    def number(self, name: str, default: float | None = None) -> float:
        """The number in a child, or the default where there is none."""
        child = self.find(name)
        if child is None and default is not None:
            return default
        return float(self.get(name).numbers(1)[0])


def read_xml(path: Path, root: str, *, local: bool = False) -> Element:
    """The root element; document types and entities of their own are refused, and so is deep nesting.

    root    its name; "": any
    local   leave out prefixes of namespaces
    raises  InputError with the line
    """
    top = xml_of(read_bytes(path), path, root, local=local)
    enter_tree(top)
    return top


def xml_of(data: bytes, path: Path, root: str, *, local: bool = False) -> Element:
    """The root element of a document of these bytes; `path` is named in messages."""
    parser = expat.ParserCreate()
    stack: list[Element] = []
    parts: list[list[str]] = []
    top: list[Element] = []

    def begin(name: str, attributes: dict[str, str]) -> None:
        name = name.rpartition(":")[2] if local else name
        element = Element(path, parser.CurrentLineNumber, name, Attributes(attributes))
        if len(stack) >= DEEPEST:
            element.fail("file.nested_too_deeply", most=DEEPEST)
        (stack[-1].children if stack else top).append(element)
        stack.append(element)
        parts.append([])

    def end(_: str) -> None:
        stack.pop().content = "".join(parts.pop())

    def characters(text: str) -> None:
        if stack:
            parts[-1].append(text)

    def doctype(*_: object) -> None:
        raise InputError("xml.doctype", file=path, line=parser.CurrentLineNumber)

    parser.buffer_text = True
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = characters, doctype
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        cut = error.lineno >= data.count(b"\n")
        detail = expat.ErrorString(error.code)
        raise InputError("xml.invalid", detail=detail, cut=cut, file=path, line=error.lineno) from None
    except (ValueError, LookupError) as error:
        raise InputError("xml.invalid", detail=str(error), cut=False, file=path, line=1) from None
    if not top:
        raise InputError("xml.empty", root=root, file=path, line=1)
    if root and top[0].name != root:
        raise InputError("xml.root_element", name=quoted(top[0].name), root=root, file=path, line=1)
    return top[0]
