"""What axe-core finds in the page: nothing serious, in any of its parts, at both sizes."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.studio.browser import Hand
from tests.studio.test_browser import SIZES, address, context, page  # noqa: F401  (fixtures)

pytest.importorskip("playwright.sync_api", reason="playwright is not installed: the page is not tested here")
pytestmark = pytest.mark.long
AXE = Path(__file__).parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"


def serious(page):  # noqa: F811
    """What is seriously wrong in the page as it stands."""
    result = page.evaluate("axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa']})")
    assert len(result["passes"]) > 10, "axe-core looked at nothing"
    return [
        (v["id"], v["impact"], [n["target"] for n in v["nodes"]][:3])
        for v in result["violations"]
        if v["impact"] in {"serious", "critical"}
    ]


def test_axe_finds_nothing_serious(page):  # noqa: F811
    """Contrast, names, roles, order of headings: rules of WCAG 2.1 A and AA."""
    if not AXE.exists():
        pytest.skip("web/node_modules is not there (cd web; npm ci): axe-core is not run here")
    script = AXE.read_text(encoding="utf-8")
    found = []
    Hand(page).new_point()
    page.evaluate(script)
    for width, height in SIZES:
        page.set_viewport_size({"width": width, "height": height})
        tabs = page.locator("#tabs [role=tab]:visible")
        for k in range(tabs.count()):
            tabs.nth(k).click()
            page.wait_for_timeout(300)
            parts = (
                page.locator("#decide-bar button:visible, #products-bar button:visible").all()
                if (width, height) == SIZES[0]
                else []
            )
            for part in parts or [tabs.nth(k)]:
                part.click()
                page.wait_for_timeout(300)
                found += [(part.inner_text(), *v) for v in serious(page)]
        assert tabs.count() >= 4
    assert not found
