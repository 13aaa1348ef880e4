"""The kernels with address and undefined-behaviour sanitizers, under tests/native.

Builds into build/sanitizers, never into the installed package, and runs the tests with that build in its place.
Prints JSON: seconds, tests, and the first finding if there is one; exit status 1 where a test fails or a sanitizer
found something.  Linux with GCC or Clang.
"""

import json
import os
import re
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/sanitizers"
FINDING = re.compile(r"^.*(?:ERROR: AddressSanitizer|runtime error:|SUMMARY: \w+Sanitizer).*$", re.MULTILINE)


def tool(name):
    """A program of this environment, or of the system."""
    own = Path(sys.executable).with_name(name)
    return str(own) if own.exists() else name


def built():
    """The compiled module."""
    common = {"capture_output": True, "text": True}
    for words in (
        [
            tool("cmake"), "-S", str(ROOT), "-B", str(BUILD / "cmake"), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
            f"-DCMAKE_MAKE_PROGRAM={tool('ninja')}", "-DRAYBUNDLE_SANITIZE=ON", f"-DPython_EXECUTABLE={sys.executable}",
        ],
        [tool("cmake"), "--build", str(BUILD / "cmake"), "--parallel", "2"],
    ):  # fmt: skip
        done = subprocess.run(words, check=False, **common)
        if done.returncode:
            sys.exit((done.stdout + done.stderr)[-3000:])
    return next((BUILD / "cmake").glob("_native*.so"))


def package(module):
    """A folder in which raybundle is the sources of this checkout with that module."""
    top = BUILD / "path"
    inner = top / "raybundle"
    inner.mkdir(parents=True, exist_ok=True)
    for link in inner.iterdir():
        link.unlink()
    for entry in (ROOT / "src/raybundle").iterdir():
        if not entry.name.startswith("_native"):
            (inner / entry.name).symlink_to(entry)
    (inner / module.name).symlink_to(module)
    return top


def library(name):
    """The compiler's copy of a run-time library."""
    compiler = os.environ.get("CXX", "c++")
    return subprocess.run(
        [compiler, f"-print-file-name={name}"], capture_output=True, text=True, check=True
    ).stdout.strip()


def main():
    began = time.perf_counter()
    module = built()
    compiled = time.perf_counter() - began
    paths = [str(package(module)), sysconfig.get_path("purelib"), sysconfig.get_path("platlib"), str(ROOT)]
    environment = {
        **os.environ,
        "PYTHONPATH": os.pathsep.join(dict.fromkeys(paths)),
        "LD_PRELOAD": f"{library('libasan.so')} {library('libubsan.so')} {library('libstdc++.so')}",
        "ASAN_OPTIONS": "detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=4000",
        "UBSAN_OPTIONS": "print_stacktrace=1:halt_on_error=1",
        "OPENBLAS_NUM_THREADS": "1",
        "PYTHONMALLOC": "malloc",
    }
    # -S: the finder of the editable installation would bring the ordinary module
    tests = sys.argv[1:] or ["tests/native"]
    words = [
        sys.executable,
        "-S",
        "-m",
        "pytest",
        "-p",
        "no:xdist",
        "-p",
        "no:cacheprovider",
        "-rA",
        "--tb=short",
        *tests,
    ]
    which = "import raybundle._native as m; print(m.__file__)"
    seen = subprocess.run(
        [sys.executable, "-S", "-c", which], env=environment, capture_output=True, text=True, check=False, cwd=ROOT
    )
    if "sanitizers" not in seen.stdout:
        sys.exit(f"the build with sanitizers is not the one that is loaded: {seen.stdout} {seen.stderr[-2000:]}")
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False, cwd=ROOT)
    text = done.stdout + done.stderr
    finding = FINDING.search(text)
    result = {
        "compile_seconds": round(compiled, 1), "seconds": round(time.perf_counter() - began, 1),
        "passed": text.count("\nPASSED "), "failed": text.count("\nFAILED "), "skipped": text.count("\nSKIPPED "),
        "finding": finding[0][-300:] if finding else None,
    }  # fmt: skip
    print(json.dumps(result, indent=1))
    if done.returncode or finding:
        print(text[-6000:], file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
