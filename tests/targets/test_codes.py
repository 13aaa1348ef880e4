"""Families of ring codes: counts, numbers, tables of one's own, choices that bear occlusion."""

import itertools

import numpy as np
import pytest

from raybundle.errors import InputError
from raybundle.targets.codes import canonical, read_table, rotations, sectors
from raybundle.targets.families import families, family_named
from raybundle.targets.subsets import choose_codes, least_distance

COUNTS = {
    "aicon12": 147, "aicon14": 516, "aicon20": 24793,
    "agisoft12": 161, "agisoft14": 561, "agisoft16": 2001, "agisoft20": 26013,
}  # fmt: skip


def test_counts():
    assert {name: len(f) for name, f in families.items()} == COUNTS


@pytest.mark.parametrize("name", COUNTS)
def test_every_reading_of_every_ring_gives_its_id(name):
    f = families[name]
    some = slice(None, None, 1 + len(f) // 3000)
    readings = rotations(f.codes[some], f.bits)
    assert (f.id_of(readings.ravel()).reshape(readings.shape) == f.ids[some, None]).all()
    assert (f.code_of(f.ids) == f.codes).all()


def test_published_rows():
    """First and last rows of the tables of 12 bits that programs print, and the one number the families share."""
    assert families["agisoft12"].codes[[0, 1, 2, -2, -1]].tolist() == [71, 75, 77, 1983, 2015]
    a, b = families["aicon14"], families["agisoft14"]
    assert len(set(a.codes) & set(b.codes)) == 515
    assert (a.codes == b.codes[: len(a)]).sum() == 1
    assert len(set(families["aicon12"].codes) & set(families["agisoft12"].codes)) == 146


def test_canonical_is_the_least_reading():
    codes = np.arange(1, 1 << 9)
    assert (canonical(codes, 9) == rotations(codes, 9).min(axis=1)).all()


def test_rings_outside_the_family_have_no_id():
    f = families["aicon14"]
    assert (f.id_of(np.array([0, 1, 0b111, (1 << 14) - 1])) == -1).all()
    with pytest.raises(InputError, match=r"517.*516.*1.*target\.no_such_id"):
        f.code_of(np.array([3, 517]))


def test_sectors():
    assert sectors(0b1100000110, 10).tolist() == [[1, 3], [8, 10]]
    assert sectors(0b1000000001, 10).tolist() == [[9, 11]]
    assert sectors(0b11111, 5).tolist() == [[0, 5]]


def test_unknown_family():
    with pytest.raises(InputError, match=r"aicon13.*agisoft12.*target\.unknown_ring_family"):
        family_named("aicon13")


def test_table_of_ones_own(tmp_path):
    file = tmp_path / "rings.csv"
    file.write_text("# id, code\n7; 6\n 2, 5 # second\n")
    f = read_table(file, 5)
    assert (f.ids.tolist(), f.codes.tolist()) == ([2, 7], [5, 3])
    assert f.id_of(np.array([0b01100, 0b10100, 1])).tolist() == [7, 2, -1]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("1 3\n1 5\n", r"2.*1.*ring_table\.id_twice"),
        ("1 3\n2 6\n", r"2.*3.*1.*ring_table\.ring_twice"),
        ("1 x\n", r"1.*ring_table\.row"),
        ("1 32\n", r"1.*32.*31.*ring_table\.code_out_of_range"),
        ("", r"ring_table\.empty"),
    ],
)
def test_bad_tables(tmp_path, text, message):
    file = tmp_path / "rings.txt"
    file.write_text(text)
    with pytest.raises(InputError, match=message):
        read_table(file, 5)


@pytest.mark.parametrize(("name", "count"), [("aicon12", 20), ("aicon14", 40), ("agisoft12", 10)])
def test_chosen_rings_share_no_visible_run(name, count):
    """Brute force: whatever stands in the hidden arc, no chosen ring turns into another."""
    f = families[name]
    choice = choose_codes(f, count)
    assert len(set(choice.ids.tolist())) == count
    assert choice.hidden >= 2
    readings = rotations(f.code_of(choice.ids), f.bits)
    for a, b in itertools.combinations(range(count), 2):
        difference = readings[a][:, None] ^ readings[b][None, :]
        assert (difference >> choice.hidden).all()
    assert choice.distance == least_distance(f.code_of(choice.ids), f.bits) >= 2


def test_a_choice_has_its_limit():
    with pytest.raises(InputError, match=r"147.*148.*target\.too_few_codes"):
        choose_codes(families["aicon12"], 148)
    assert choose_codes(families["aicon12"], 147).hidden == 1  # parity tells a single sector
