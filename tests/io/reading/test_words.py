"""Numbers, quoted texts, JSON, TOML, XML and CSV as the one reading place gives them."""

import math
import os
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from raybundle.errors import InputError
from raybundle.io.reading import words
from raybundle.io.reading.files import read_lines, read_text
from raybundle.io.reading.rows import BadRow, cells_of
from raybundle.io.reading.trees import json_of, python_of, read_json, read_toml
from raybundle.io.reading.xml import read_xml

GOOD = {"1": 1.0, "-2.5": -2.5, "+.5": 0.5, "3.": 3.0, "1e3": 1000.0, "1E-3": 0.001, "1e18": 1e18, "-0": -0.0}
BAD = [
    "", " 1", "1 ", "1_000", "１２", "٣", "nan", "inf", "-inf", "Infinity", "1e999", "1e19", "-1e308", "0x10", "1,5",
    "1.2.3", "1e", "--1", ".", "e5", "1" * 5000,  "0.0.0", "1\0", "1\n", "true", "²", "1j",
]  # fmt: skip


@pytest.mark.parametrize("word", GOOD)
def test_numbers_are_taken(word):
    assert words.number_of(word) == GOOD[word]
    assert words.column_of([word]).tolist() == [GOOD[word]]


@pytest.mark.parametrize("word", BAD, ids=range(len(BAD)))
def test_what_float_takes_and_a_file_must_not_hold(word):
    assert words.number_of(word) is None
    assert words.numbers_of(["1", word]) is None
    if word:
        assert words.column_of(["1", word]) is None


@given(st.floats(-1e18, 1e18))
def test_numbers_come_back(value):
    found = words.number_of(repr(value))
    assert found == (value if abs(value) >= words.SMALLEST else 0.0)
    assert words.column_of([repr(value), ""])[0] == found


@given(st.lists(st.text("0123456789.eE+-_ nainf１٣", max_size=6), min_size=1, max_size=4))
def test_a_column_is_what_its_cells_are(cells):
    single = [math.nan if c == "" else words.number_of(c) for c in cells]
    column = words.column_of(cells)
    if None in single:
        assert column is None
    else:
        np.testing.assert_array_equal(column, single)


def test_what_overflows_the_reciprocal_is_zero():
    assert words.number_of("5e-324") == 0.0
    assert words.finite(1e-101) == 0.0
    assert words.finite(1e-99) == 1e-99


@pytest.mark.parametrize("value", [True, None, "1", math.nan, math.inf, 10**400, 1e19, [], 1j], ids=range(9))
def test_values_that_are_no_numbers(value):
    assert words.finite(value) is None


def test_whole_numbers_are_bounded():
    assert words.whole_of("-12") == -12
    assert all(words.whole_of(w) is None for w in ("1.0", "1e3", "1" * 5000, "٣", "1_0", "", " 1"))


@pytest.mark.parametrize(
    "value",
    ["a\0b\x1b[2J", "\u202egnp.exe", "x" * 100_000, ["y" * 9999] * 99, 10**6000, {"k": {"k": [[[[[1]]]]]}}, "\udc80"],
    ids=range(7),
)
def test_foreign_texts_in_messages_are_short_and_printable(value):
    text = words.quoted(value)
    assert text.isprintable()
    assert len(text) <= 200
    error = InputError(
        f"{value!r:.100000} stands {value}" if not isinstance(value, int) else text, column=f"{text * 9}"
    )
    assert len(str(error)) < 2500
    assert str(error).replace("\n", "").isprintable()


def nested(depth):
    value = "1"
    for _ in range(depth):
        value = f"[{value}]"
    return value


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('{"a": NaN}', r"NaN.*JSON.*json\.not_finite"),
        ('{"a": [1,\n -Infinity]}', r"2.*Infinity.*json\.not_finite"),
        ('{"a": 1, "b": {"c": 1, "c": 2}}', r"json\.key_twice"),
        (nested(101), r"100.*file\.nested_too_deeply"),
        ("[" * 100_000, r"100.*file\.nested_too_deeply"),
        ("[" * 2_000_000, r"file\.nested_too_deeply"),
        ("1" * 5000, r"file\.number_too_long"),
        ('{"a": ', r"json\.invalid"),
        ('{"a": 1}\0', r"file\.control_character"),
    ],
    ids=range(9),
)
def test_json_that_is_refused(tmp_path, text, message):
    path = tmp_path / "a.json"
    path.write_text(text)
    with pytest.raises(InputError, match=message) as caught:
        read_json(path)
    assert str(path) in str(caught.value)


def test_json_in_bounds(tmp_path):
    assert json_of(nested(100), tmp_path)
    assert json_of('["' + "[" * 500 + '", {"a": "\\""}]', tmp_path)[1] == {"a": '"'}
    (tmp_path / "a.json").write_bytes(b'\xef\xbb\xbf{"a": {"b": [1e999, 18446744073709551615]}}')
    value = read_json(tmp_path / "a.json").get("a").get("b").items()
    assert value[1].whole(0, 1 << 64) == 18446744073709551615
    with pytest.raises(InputError, match=r"a\.b\.0.*value\.not_finite"):
        value[0].number()


@pytest.mark.parametrize(
    ("text", "message", "line"),
    [
        ("a = 1\nb = ", r"toml\.invalid", 2),
        ("a = 1\na = 2", r"Cannot.*toml\.invalid", None),
        ("a = " + "1" * 5000, r"file\.number_too_long", None),
        ("a = " + nested(101), r"100.*file\.nested_too_deeply", None),
        ("a = 1\n\0", r"file\.control_character", 2),
        ("a = '\xff'".encode("latin-1"), r"file\.not_utf8", 1),
        (b"\xff\xfea", r"file\.not_utf8", 1),
    ],
    ids=range(7),
)
def test_toml_that_is_refused(tmp_path, text, message, line):
    path = tmp_path / "a.toml"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(InputError, match=message) as caught:
        read_toml(path)
    assert line is None or caught.value.line == line


def test_toml_knows_the_lines_of_its_keys(tmp_path):
    (tmp_path / "a.toml").write_text('x = 1\n[cameras."a b"]\nc = nan\n')
    found = read_toml(tmp_path / "a.toml")
    assert found.lines["cameras", "a b", "c"] == 3
    with pytest.raises(InputError, match=r"value\.not_finite"):
        found.tree().get("cameras").get("a b").get("c").number()


@pytest.mark.parametrize(
    "text", ["{'a': [1,", "__import__('os')", "[" * 3000, "'" + "a" * 10 + "' + 1", "{[]: 1}", "1" * 5000]
)
def test_python_literals_that_are_refused(tmp_path, text):
    with pytest.raises(InputError):
        python_of(text, tmp_path)


def test_rows():
    assert list(cells_of(["a,b", '"c,""d",e'])) == [["a", "b"], ['c,"d', "e"]]
    for bad in ('"open', 'a,"b"c', "a\rb"):
        with pytest.raises(BadRow) as caught:
            list(cells_of(["a,b", bad]))
        assert caught.value.position == 1


def test_xml_numbers_and_time(tmp_path):
    path = tmp_path / "a.xml"
    path.write_text("<a><b>1 2</b><c>1_0</c><d>nan</d><e v='1e999'/></a>")
    top = read_xml(path, "a")
    assert top.get("b").numbers(2).tolist() == [1, 2]
    for name in "cd":
        with pytest.raises(InputError, match=r"value\.not_finite"):
            top.number(name)
    with pytest.raises(InputError, match=r"xml\.attribute_not_a_number"):
        top.get("e").value("v")


def test_texts(tmp_path):
    path = tmp_path / "a.txt"
    path.write_bytes(b"\xef\xbb\xbfa\r\nb\rc\x0c\n")
    assert read_text(path) == "a\nb\rc\x0c\n"
    assert [line for _, line in read_lines(path)] == ["a", "b", "c\x0c", ""]
    with pytest.raises(InputError, match=r"file\.not_a_file"):
        read_text(tmp_path)
    with pytest.raises(InputError, match=r"3.*file\.too_large"):
        read_text(path, 3)
    with pytest.raises(InputError, match=r"file\.impossible_name"):
        read_text(tmp_path / "a\0b")


@pytest.mark.skipif(not os.path.exists("/dev/zero"), reason="the system has no /dev/zero")  # noqa: PTH110
def test_devices_do_not_fill_the_memory():
    from pathlib import Path

    with pytest.raises(InputError, match=r"file\.not_a_file"):
        read_text(Path("/dev/zero"))


def test_pythons_own_limit_of_digits_is_not_relied_upon():
    before = sys.get_int_max_str_digits()
    try:
        sys.set_int_max_str_digits(0)
        assert words.whole_of("1" * 5000) is None
        assert words.number_of("1" * 5000) is None
    finally:
        sys.set_int_max_str_digits(before)
