"""Exact depths of the rendered portal, kept in pytest's cache."""

from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def portal_cache(request):
    """Where exact depths are kept; skips where rays cannot be cast in a minute."""
    pytest.importorskip("embreex", reason="embreex is not installed: no exact depths of the portal")
    return Path(request.config.cache.mkdir("surface"))


@pytest.fixture(scope="session")
def truth(portal_cache):
    """`Portal`: exact depth, incidence and sheet of every pixel of every photograph."""
    from tests.surface.truth import Portal

    return Portal(portal_cache)
