"""Classes of standard deviations: told by what was wanted, what prints alike is one, and the worst is told."""

import base64
import json
import re

import numpy as np
import pytest

from raybundle.cli.main import main
from raybundle.errors import phrase
from raybundle.report.network.page import extent_of
from raybundle.report.network.sigma_classes import GOOD, MISSED, SHADES, sigma_classes
from tests.studio.browser import ARGUMENTS, chromium

RNG = np.random.default_rng(5)

FAR_BELOW = phrase("sigma_class.by_wanted", place="far_below", limit=1.0, unit="mm")


def class_of(classes, value):
    return classes.colours[sum(value > limit for limit in classes.limits)]


def words_of(classes):
    return [words for _, words in classes.legend]


def test_red_is_only_what_is_above_what_was_wanted():
    values = RNG.uniform(0.2, 4, 500)
    classes = sigma_classes(values, "mm", 2.0)
    for value in values:
        assert (class_of(classes, value) in MISSED) == (value > 2)
    assert [class_of(classes, v) for v in (0.9, 1.2, 1.9, 2.0, 2.5, 3)] == [*GOOD, GOOD[2], *MISSED]
    assert not set(SHADES) & set(MISSED)
    assert "wanted: 2 mm" in words_of(classes)[0]
    assert words_of(classes)[-1] == f"worst: {values.max():.3g} mm"
    all_good = sigma_classes(np.linspace(0.3, 0.93, 50), "mm", 2.0)
    assert words_of(all_good)[1:] == [FAR_BELOW, "worst: 0.93 mm"]


def test_drawn_in_single_precision_what_is_wanted_is_kept():
    wanted = 0.1
    classes = sigma_classes(np.array([wanted, 0.2]), "mm", wanted)
    assert class_of(classes, float(np.float32(wanted))) == GOOD[2]


@pytest.mark.parametrize("scale", [1e-6, 1.0, 3e4])
def test_what_prints_alike_is_one_class(scale):
    alike = sigma_classes(scale * (5.2 + RNG.uniform(-0.04, 0.04, 100)), "mm")
    assert len(alike.colours) == 1
    assert alike.limits == ()
    spread = sigma_classes(scale * RNG.lognormal(0, 1, 400), "mm")
    assert len(spread.colours) == 5
    for classes in (alike, spread, sigma_classes(scale * RNG.normal(5.2, 0.05, 100), "mm")):
        said = [w for c, w in classes.legend if c]
        assert len(set(said)) == len(said) == len(classes.colours)
        assert list(classes.limits) == sorted(set(classes.limits))


def test_a_number_lies_in_the_class_that_its_print_is_in():
    classes = sigma_classes(np.array([1.0, 1.04, 1.2, 1.24, 1.4, 1.6, 1.9, 3.0]), "mm")
    for limit in classes.limits:
        assert class_of(classes, limit * (1 - 1e-3)) != class_of(classes, limit * 1.01)
    assert class_of(classes, 1.0) == class_of(classes, 1.04)


def test_nothing_known_has_no_classes_and_what_is_not_known_is_told():
    assert sigma_classes(np.full(3, np.nan), "mm") is None
    assert sigma_classes(np.zeros(0), "mm") is None
    assert sigma_classes(np.zeros(4), "mm").limits == ()
    some = sigma_classes(np.array([1.0, np.nan]), "mm", unknown="not seen")
    assert words_of(some)[-1] == "not seen"
    assert "not seen" not in words_of(sigma_classes(np.array([1.0, 2.0]), "mm", unknown="not seen"))


def test_far_points_do_not_widen_the_first_view():
    object_ = RNG.uniform(-1, 1, (60, 3)) * [6, 4, 0]
    alone = extent_of(object_)
    far = np.concatenate([object_, [[400.0, 10, 5]], RNG.normal(0, 300, (12, 3))])
    assert extent_of(far) == pytest.approx(alone, rel=0.1)
    for even in (
        object_,
        RNG.uniform(-1, 1, (500, 3)),
        RNG.uniform(-1, 1, (500, 3)) * [1, 0, 0],
        RNG.normal(0, 1, (500, 3)),
    ):
        low, high = np.quantile(even, [0.02, 0.98], axis=0)
        assert extent_of(even) == pytest.approx(np.linalg.norm(high - low), rel=0.03)


@pytest.fixture(scope="module")
def planned(tmp_path_factory):
    folder = tmp_path_factory.mktemp("plan")
    words = ["plan", "network", "facade:12,8", "--sigma", "0.16", "--effort", "quick", "--object-points", "40"]
    assert main([*words, "--progress", "none", "--out", str(folder / "plan")]) == 0
    return folder / "plan"


@pytest.mark.long
def test_the_page_of_a_plan_has_what_was_wanted(planned):
    html = (planned / "network.html").read_text(encoding="utf-8")
    data = json.loads(re.search(r'id="network-data">(.*?)</script>', html, re.DOTALL).group(1))
    assert phrase("network_page.wanted", sigma=0.16, unit="mm", what="worst").partition(".")[0] in html
    assert f"<title>{phrase('network_plan.title', name='facade:12,8')}</title>" in html
    for part, sigma in (("points", data["points"]["sigma"]), ("surface", data["surface"]["sigma"])):
        classes = data["classes"][part]
        values = np.frombuffer(base64.b64decode(sigma), "<f4").astype(float)
        if part == "points":
            values = np.sqrt(np.mean(values.reshape(-1, 3) ** 2, axis=1))
        colours = {classes["colours"][sum(v > x for x in classes["limits"])] for v in values[np.isfinite(values)]}
        assert colours == {c for c, _ in classes["legend"] if c} - {"#999999"}
        assert bool(colours & set(MISSED)) == bool((values > 0.16 * (1 + 1e-6)).any())
        assert "wanted: 0.16 mm" in classes["legend"][0][1]


@pytest.mark.long
def test_the_page_says_so_in_a_browser(planned):
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if chromium() is None:
        pytest.skip("no Chromium is here (RAYBUNDLE_CHROMIUM may name one)")
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium(), args=list(ARGUMENTS))
        page, wrong = browser.new_page(), []
        page.on("pageerror", lambda e: wrong.append(str(e)))
        page.goto(f"file://{planned / 'network.html'}")
        page.wait_for_selector("#legend li")
        said = page.inner_text("#legend")
        browser.close()
    assert not wrong
    assert "wanted: 0.16 mm" in said
    assert "worst: " in said
