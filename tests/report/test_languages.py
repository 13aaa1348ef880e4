"""Reports in other languages than English."""

import re
from dataclasses import replace
from datetime import UTC, datetime
from functools import cache
from html import unescape

import pytest

import raybundle
from raybundle import words
from raybundle.adjustment.records.notice import Notice
from raybundle.errors import InputError, Text
from raybundle.report.languages import Localised, language_codes
from raybundle.report.languages.language import UNITS, Language, language_of
from raybundle.report.paper.copy import copy_of
from raybundle.report.writing import write_report

from .conftest import MAKERS, made

OTHERS = ("de",)
"""French has the client's page; the specialist's texts are English there."""
SIMULATED = [name for name in MAKERS if name != "hostile"]
WORD = re.compile(r"(?<![\w./=-])[A-Za-z]?[a-z]{3,}(?![\w./=-])")
LATIN = {"sigma", "nan", "Baarda", "Bonferroni", "Pope"}
"""Words and names that are the same in every language"""


@cache
def words_of(names):
    return {w for n in names for w in WORD.findall(n)} | names


def english_atoms(language: Language, run) -> list[str]:
    """Texts with words, other than names, that are no messages: they stay as they are in every language."""
    left: list[str] = []
    plain = Language.text

    def watched(self, text):
        if self.code == language.code and not isinstance(text, Text | Localised):
            names = words_of(self.names)
            if text not in names and set(WORD.findall(UNITS.sub("", text))) - names - LATIN:
                left.append(text)
        return plain(self, text)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Language, "text", watched)
        run()
    return left


@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", ["rich", "rejected"])
def test_no_atom_of_a_report_stays_english(code, name, tmp_path):
    adjustment = made(name)
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


@pytest.mark.long
@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", [n for n in SIMULATED if n not in {"rich", "rejected"}])
def test_no_atom_of_any_simulated_report_stays_english(code, name, tmp_path):
    adjustment = made(name)
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


BLOCKS = ("aicon", "camcal21", "prague-s1", "rc30-pair", "resection-wuhan", "riva-net1", "sxb")


@pytest.mark.long
@pytest.mark.parametrize("code", OTHERS)
@pytest.mark.parametrize("name", BLOCKS)
def test_no_atom_of_a_measured_block_stays_english(code, name, tmp_path, blocks):
    folder = blocks / name
    if not folder.is_dir():
        pytest.skip(f"{folder} is not here")
    adjustment = raybundle.adjust(raybundle.read_block(folder))
    left = english_atoms(language_of(code), lambda: write_report(adjustment, tmp_path / "r.html", language=code))
    assert not left, "\n".join(left)


def test_a_text_without_a_message_is_noticed(tmp_path):
    adjustment = replace(made("rich"), notices=(Notice(code="gps", message="somebody moved the tripod"),))
    left = english_atoms(language_of("de"), lambda: write_report(adjustment, tmp_path / "r.html", language="de"))
    assert any("tripod" in words for words in left)


def test_numbers_dates_and_names():
    german = language_of("de", ["1.5", "control"])
    assert german.text("X 0.12, Y 0.3, Z 1.25 mm") == "X 0,12; Y 0,3; Z 1,25 mm"
    assert german.text("2026-11-26") == "26.11.2026"
    assert german.text("2026-13-26") == "2026-13-26"
    assert german.cell("1.5") == "1.5"  # a point of this name
    assert german.cell("1.6") == "1,6"
    assert german.moment(datetime(2026, 11, 6, 8, 30, tzinfo=UTC)) == "06.11.2026 08:30"


def test_english_is_left_alone():
    english = language_of()
    assert english.text("12 images, 0.5 px") == "12 images, 0.5 px"
    assert english.english


def test_the_page_says_its_language(tmp_path):
    for code in language_codes():
        write_report(made("rich"), tmp_path / "r.html", language=code)
        page = (tmp_path / "r.html").read_text(encoding="utf-8")
        assert f'<html lang="{code}">' in page
    write_report(made("rich"), tmp_path / "r.html", language="de")
    page = unescape((tmp_path / "r.html").read_text(encoding="utf-8"))
    assert "Für den Auftraggeber" in page
    assert "Standardabweichung" in page


def test_paper_says_its_language():
    from raybundle.report.document import Document

    document = Document(title="x", subtitle="", headline="", grade="good", made=(), language=language_of("de"))
    copy = copy_of(document)
    assert copy["language"] == "de"
    assert copy["page"] == ["Seite", "von"]


def test_a_language_that_there_is_not_is_refused(tmp_path):
    with pytest.raises(InputError, match="en, de"):
        write_report(made("rich"), tmp_path / "r.html", language="xx")


FOREIGN = re.compile(r"(?<![\w./:-])(the|of|and|with|from|is|are|points?|photographs?|without)(?![\w./-])")
"""English words that no other language here has"""


GERMAN = words.Reader("de", flags=True)


def test_pages_of_a_plan_are_in_the_language_of_its_reader(tmp_path):
    with words.reading(GERMAN):
        raybundle.plan_network(
            "facade:6,4", tmp_path / "network", photographs=8, object_points=30, rays=2, effort="quick",
            measured="natural", scale_bars=2,
        )  # fmt: skip
        raybundle.plan_list("calibration", "sheet:0.42,0.297", tmp_path / "list", f_number=8.0)
        area = "7.1 50.1, 7.105 50.1, 7.105 50.103, 7.1 50.103"
        flown = raybundle.plan_mission(area, tmp_path / "mission", vehicle="mavic-2-pro", height=150.0)
        texts = [w.text() for w in flown.warnings]
    page = (tmp_path / "network/network.html").read_text(encoding="utf-8")
    assert ' lang="de">' in page
    head, script = page.partition("<body")[2].split("<script", 1)
    texts += [unescape(re.sub(r"<[^>]*>", " ", head)), *re.findall(r'"words":(\[.*?\]|\{.*?\})', script)]
    texts += [(tmp_path / name).read_text(encoding="utf-8") for name in ("network/stations.csv", "list/list.csv")]
    texts.append(re.sub(r'"\w+":', "", (tmp_path / "list/list.json").read_text(encoding="utf-8")))
    texts += re.findall(r"<text[^>]*>([^<]*)", (tmp_path / "mission/mission.svg").read_text(encoding="utf-8"))
    heads = "points,what_for"
    left = {m[0]: t[:200] for t in texts for m in FOREIGN.finditer(t.replace(heads, ""))}
    assert not left


@pytest.mark.parametrize("draw", [raybundle.plot_residuals, raybundle.plot_interior, raybundle.plot_network])
def test_figures_are_in_the_language_of_their_reader(draw):
    with words.reading(GERMAN):
        figure = draw(made("rich"))
    titles = [figure.get_suptitle()]
    for axes in figure.axes:
        titles += [axes.get_title(), axes.get_xlabel(), axes.get_ylabel(), *axes.get_legend_handles_labels()[1]]
    assert not [t for t in titles if FOREIGN.search(t)]
