"""What is printed where a stream cannot hold every sign, as a pipe on Windows."""

import io
import os
import subprocess
import sys

from raybundle.cli.main import _printable


def test_a_sign_that_a_stream_cannot_hold_is_a_question_mark():
    kept = io.BytesIO()
    stream = io.TextIOWrapper(kept, encoding="cp1252")
    _printable(stream)
    stream.write("± σ0")
    stream.flush()
    assert kept.getvalue() == b"\xb1 ?0"


def test_a_stream_that_says_itself_what_happens_stays_as_it_is():
    stream = io.TextIOWrapper(io.BytesIO(), encoding="ascii", errors="backslashreplace")
    _printable(stream)
    assert stream.errors == "backslashreplace"
    _printable(io.StringIO())


def test_a_folder_in_another_script_is_named_through_a_narrow_pipe(tmp_path):
    words = [sys.executable, "-m", "raybundle", "simulate", "flat", "--out", "Ωmega", "--scale-bars", "1"]
    done = subprocess.run(
        words, cwd=tmp_path, env={**os.environ, "PYTHONIOENCODING": "cp1252"}, capture_output=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert b"?mega" in done.stdout
