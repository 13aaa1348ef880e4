"""A server that is killed while somebody measures: what was acknowledged is there, and nothing twice."""

import contextlib
import json
import random
import re
import subprocess
import sys
from http.client import HTTPConnection, HTTPException
from pathlib import Path
from urllib.parse import urlsplit

from raybundle.measuring.journal import entries_of, journal_path
from tests.barriers import DEADLINE_S


class Browser:
    """What a page does: it enters, and sends each action until it is answered."""

    def __init__(self, project: Path) -> None:
        self.project = project
        self.start()

    def start(self) -> None:
        command = [sys.executable, "-m", "raybundle", "studio", str(self.project), "--no-browser"]
        self.server = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        address = re.search(r"http://\S+", self.server.stdout.readline())
        assert address is not None, "the server did not start"
        parts = urlsplit(address[0])
        self.at, self.origin = (parts.hostname, parts.port), f"http://{parts.netloc}"
        connection = HTTPConnection(*self.at, timeout=DEADLINE_S)
        connection.request("GET", f"/?{parts.query}")
        self.cookie = connection.getresponse().headers["set-cookie"].split(";")[0]
        connection.close()

    def send(self, action: dict) -> int | None:
        """The status of an answer; None where there was none."""
        connection = HTTPConnection(*self.at, timeout=DEADLINE_S)
        headers = {"content-type": "application/json", "origin": self.origin, "cookie": self.cookie}
        try:
            connection.request("POST", "/api/action", json.dumps(action), headers)
            return connection.getresponse().status
        except (OSError, HTTPException):
            return None
        finally:
            connection.close()

    def kill(self) -> None:
        self.server.kill()
        self.server.wait()
        self.server.stdout.close()


def measure_under_kills(project: Path, image: str, kills: int, seed: int) -> dict[str, int]:
    """Measure while the server is killed so many times at random instants; counts of what was sent and is kept."""
    rng = random.Random(seed)
    browser = Browser(project)
    acknowledged: list[str] = []
    resent = number = 0
    for _ in range(kills):
        left = rng.randint(1, 40)
        pending: dict | None = None
        killed = False
        while not killed:
            action = {
                "id": f"click-{number}", "verb": "put",
                "arguments": {"image": image, "point": f"p{number}", "x_px": 5.0 + number % 900, "y_px": 7.0},
            }  # fmt: skip
            number += 1
            left -= 1
            if not left:
                # the kill arrives while the action is on its way
                killer = subprocess.Popen(
                    ["sh", "-c", f"sleep {rng.uniform(0, 0.004):.4f}; kill -9 {browser.server.pid}"]
                )
                status = browser.send(action)
                killer.wait()
                killed = True
            else:
                status = browser.send(action)
            if status == 200:
                acknowledged.append(action["id"])
            else:
                assert killed, status
                pending = action
        with contextlib.suppress(OSError):
            browser.kill()
        browser.start()
        if pending is not None:
            resent += 1
            assert browser.send(pending) == 200
            acknowledged.append(pending["id"])
    browser.kill()
    kept = [e.id for e in entries_of(journal_path(project))]
    assert kept == acknowledged, "an acknowledged action is lost, or one counts twice"
    return {"kills": kills, "actions": number, "sent_again": resent}
