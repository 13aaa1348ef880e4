"""However the server ends, nothing of it stays behind."""

import contextlib
import http.client
import os
import signal
import subprocess
import sys
from urllib.parse import urlsplit

import pytest

from raybundle.cli.main import main
from tests.barriers import DEADLINE_S


def started(project, temporary):
    environment = {**os.environ, "TMPDIR": str(temporary)}
    command = [sys.executable, "-m", "raybundle", "studio", str(project), "--no-browser"]
    server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    line = server.stdout.readline()
    assert "http://127.0.0.1:" in line
    address = urlsplit(next(word for word in line.split() if word.startswith("http://")))
    # who connects before the server answers waits until it does
    with contextlib.closing(
        http.client.HTTPConnection(address.hostname, address.port, timeout=DEADLINE_S)
    ) as connection:
        connection.request("GET", "/")
        assert connection.getresponse().status == 401
    return server


def test_a_language_without_a_catalogue_is_refused(tmp_path, capsys):
    assert main(["studio", str(tmp_path), "--no-browser", "--language", "xx"]) == 2
    assert "report.unknown_language" in capsys.readouterr().err
    assert not [*tmp_path.iterdir()]


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.long
def test_decoded_photographs_go_with_the_server(project, tmp_path):
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT, signal.SIGKILL):
        server = started(project, temporary)
        server.send_signal(number)
        server.wait(DEADLINE_S)
        server.stdout.close()
        left = [p.name for p in temporary.glob("raybundle-studio-*")]
        assert len(left) == (1 if number == signal.SIGKILL else 0), number
    # what a killed one left goes when the next begins
    server = started(project, temporary)
    assert len(list(temporary.glob("raybundle-studio-*"))) == 1
    server.send_signal(signal.SIGINT)
    server.wait(DEADLINE_S)
    server.stdout.close()
    assert list(temporary.glob("raybundle-studio-*")) == []
