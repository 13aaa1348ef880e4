"""The built script of the page is what its sources make."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WEB = ROOT / "web"
BUILT = {
    "studio/studio.ts": ROOT / "src/raybundle/studio/static/studio.js",
    "network/network.ts": ROOT / "src/raybundle/report/templates/network.js",
}


@pytest.fixture(scope="module")
def tools():
    if shutil.which("node") is None:
        pytest.skip("node is not installed: the built script is not built again here")
    if not (WEB / "node_modules" / ".bin" / "esbuild").exists():
        pytest.skip("web/node_modules is not there (cd web; npm ci): the built script is not built again here")
    return WEB / "node_modules" / ".bin"


@pytest.mark.parametrize("source", BUILT)
def test_built_again_it_is_the_same(tools, source, tmp_path):
    options = ["--bundle", "--minify", "--format=iife", "--target=es2021", "--legal-comments=eof"]
    subprocess.run([tools / "esbuild", source, *options, f"--outfile={tmp_path / 'out.js'}"], cwd=WEB, check=True)
    assert (tmp_path / "out.js").read_bytes() == BUILT[source].read_bytes(), f"{source}: cd web; npm run build"


def test_types(tools):
    done = subprocess.run([tools / "tsc", "--noEmit"], cwd=WEB, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_licences_stay_in_the_bundle():
    for built in BUILT.values():
        assert "SPDX-License-Identifier: MIT" in built.read_text(encoding="utf-8")
    assert "SPDX-License-Identifier: Apache-2.0" in BUILT["studio/studio.ts"].read_text(encoding="utf-8")


def test_the_page_has_nothing_that_its_policy_forbids():
    page = (BUILT["studio/studio.ts"].parent / "index.html").read_text(encoding="utf-8")
    for forbidden in (" style=", "<style", "onclick", "javascript:", "data:", "http://", "https://"):
        assert forbidden not in page
    script = BUILT["studio/studio.ts"].read_text(encoding="utf-8")
    sources = "".join(p.read_text(encoding="utf-8") for p in (WEB / "studio").glob("*.ts"))
    for forbidden in (
        "innerHTML",
        "outerHTML",
        "insertAdjacentHTML",
        "document.write",
        "eval(",
        "new Function",
        "data:image",
    ):
        assert forbidden not in sources
    assert "new Function" not in script


def test_modules_stay_readable():
    for path in [*(WEB / "studio").glob("*.ts"), *(WEB / "common").glob("*.ts")]:
        assert len(path.read_text(encoding="utf-8").splitlines()) <= 400, path.name
