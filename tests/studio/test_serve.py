"""However the server ends, nothing of it stays behind."""

import os
import signal
import subprocess
import sys
import time

import pytest


def started(project, temporary):
    environment = {**os.environ, "TMPDIR": str(temporary)}
    command = [sys.executable, "-m", "raybundle", "studio", str(project), "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    assert "http://127.0.0.1:" in server.stdout.readline()
    return server


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.long
def test_decoded_photographs_go_with_the_server(project, tmp_path):
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGKILL):
        server = started(project, temporary)
        time.sleep(1.0)
        server.send_signal(number)
        server.wait(30)
        server.stdout.close()
        left = [p.name for p in temporary.glob("raybundle-studio-*")]
        assert len(left) == (1 if number == signal.SIGKILL else 0), number
    # what a killed one left goes when the next begins
    server = started(project, temporary)
    assert len(list(temporary.glob("raybundle-studio-*"))) == 1
    server.send_signal(signal.SIGINT)
    server.wait(30)
    server.stdout.close()
    assert list(temporary.glob("raybundle-studio-*")) == []
