"""What further photographs would gain stands as two uncertainties and their difference."""

from types import SimpleNamespace

from raybundle.errors import code_of, phrase
from raybundle.report.sections.calibration import calibration_section


def advised(grade="usable"):
    advice = (SimpleNamespace(words=phrase("next_photograph.same_place", name="12"), uncertainty_px=0.29, ratio=0.58),)
    return SimpleNamespace(
        camera="A", grade=grade, headline=phrase("calibration_quality.head_weak"), reasons=(), validation=None,
        typical_px=0.1, uncertainty_px=0.5,
        likely_px=0.4, worst_px=0.9, inside_px=0.9, image_sigma_px=0.1, coverage=0.9, reach=0.9, photographs=9, rolls=1,
        convergence=0.5, unstable=False, advice=advice, couplings=(),
    )  # fmt: skip


def row_of(quality):
    tables = [p for p in calibration_section((quality,)).parts if p.kind == "table"]
    return [code_of(c.label).partition(".")[2] for c in tables[0].columns if c.label], tables[0].rows[0]


def test_what_further_photographs_gain_is_told_as_now_then_and_by_how_much():
    labels, row = row_of(advised())
    assert labels == ["photographs_in_order", "uncertainty_now", "uncertainty_then", "smaller_by"]
    assert code_of(row[1]) == "next_photograph.same_place"
    assert (row[0], *row[2:]) == ("1", "0.50", "0.29", "42 %")


def test_what_is_not_determinable_now_has_no_number():
    _, row = row_of(advised("not determinable"))
    assert row[2] == "–"
