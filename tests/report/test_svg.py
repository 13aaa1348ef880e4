"""Drawing: round ticks, intervals, escaped words, thinning that is always the same."""

import re

import numpy as np
import pytest

from raybundle.report.figures.svg import (
    Plot,
    axes,
    coordinates,
    fitted,
    histogram,
    label,
    round_below,
    round_step,
    span,
    spread_rows,
    tick_labels,
    ticks,
    vectors,
)


@pytest.mark.parametrize("interval", [(0.0, 1.0), (-3.7e-5, 8.1e-5), (17.0, 4711.0), (1e6 - 3, 1e6 + 4)])
def test_ticks_are_round_and_inside(interval):
    values = ticks(interval)
    step = values[1] - values[0]
    assert 3 <= len(values) <= 8
    assert values[0] >= interval[0] - 1e-9 * step
    assert values[-1] <= interval[1] + 1e-9 * step
    mantissa = step / 10.0 ** np.floor(np.log10(step) + 1e-9)
    assert min(abs(mantissa - m) for m in (1, 2, 5)) < 1e-6
    assert len(set(tick_labels(values))) == len(values)


def test_round_numbers():
    assert [round_step(1.0, n) for n in (1, 2, 4, 10)] == pytest.approx([1.0, 0.5, 0.2, 0.1])
    assert [round_below(v) for v in (0.99, 1.0, 4.9, 73.0)] == pytest.approx([0.5, 1.0, 2.0, 50.0])


def test_intervals_are_never_empty():
    assert span(np.array([np.nan])) == (0.0, 1.0)
    low, high = span(np.full(3, 5.0))
    assert low < 5 < high
    assert span(np.array([2.0, 4.0]), zero=True)[0] == 0.0


def test_plot_maps_the_range_onto_the_box():
    plot = Plot(x_range=(2.0, 4.0), y_range=(-1.0, 1.0))
    x, y, w, h = plot.box
    assert plot.x(np.array([2.0, 4.0])) == pytest.approx([x, x + w])
    assert plot.y(np.array([-1.0, 1.0])) == pytest.approx([y + h, y])
    assert fitted(Plot(x_range=(0, 1), y_range=(0, 2e5))).left > fitted(Plot(x_range=(0, 1), y_range=(0, 5))).left


def test_words_are_escaped():
    assert "<b>" not in label(0, 0, "<b>&")
    assert "&lt;b&gt;&amp;" in label(0, 0, "<b>&")
    assert "<i>" not in axes(Plot(x_range=(0, 1), y_range=(0, 1)), "<i>", "<i>")


def test_lines_have_gaps_where_values_are_missing():
    x = np.arange(5.0)
    assert coordinates(x, np.array([0, 1, np.nan, 1, 0.0])).count("M") == 2
    one = np.array([1.0, 2.0])
    assert vectors(one, one, np.array([1.0, np.nan]), one, "vector").count("M") == 1


def test_histogram_counts_all_finite_values():
    drawn = histogram(np.array([0.1, 0.2, 5.0, np.nan]), "x", "what", edges=np.array([0.0, 1.0, 2.0]))
    assert "what" in drawn.svg
    assert drawn.svg.count('class="bar"') == 1
    flat = histogram(np.full(4, 3.0), "x", "what")
    assert "nan" not in flat.svg


def test_thinning_is_even_and_keeps_both_ends():
    assert list(spread_rows(3, 10)) == [0, 1, 2]
    rows = spread_rows(1000, 10)
    assert len(rows) == 10
    assert rows[0] == 0
    assert rows[-1] == 999
    assert np.ptp(np.diff(rows)) <= 1


def test_labels_do_not_overlap_in_a_narrow_plot():
    narrow = axes(Plot(width=136, x_range=(-700.0, 1350.0), y_range=(0, 1)), "x", "y")
    wide = axes(Plot(width=500, x_range=(-700.0, 1350.0), y_range=(0, 1)), "x", "y")

    def labelled(drawn):
        return [float(x) for x in re.findall(r'x="([\d.]+)" y="[\d.]+" text-anchor="middle">[−\d]', drawn)]

    assert len(labelled(wide)) > len(labelled(narrow)) >= 1
    assert min(np.diff(labelled(narrow)), default=100) > 28
