"""Schedulers and workers as processes of their own, and a line between them that can be cut."""

import contextlib
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
from pathlib import Path

ROOT = Path(__file__).parents[2]


class Machines:
    """A cluster on this machine, by the commands that a user types."""

    def __init__(self, folder, *, namespace=""):
        self.folder, self.namespace, self.running = folder, namespace, []

    def command(self, *words, wait="", namespace=""):
        """Begin a command of raybundle, and wait until it has said a line."""
        inside = ["ip", "netns", "exec", namespace] if namespace else []
        process = subprocess.Popen(
            [*inside, sys.executable, "-m", "raybundle", *map(str, words)], stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": str(ROOT)}, cwd=self.folder.parent,
            start_new_session=True,
        )  # fmt: skip
        self.running.append(process)
        line = process.stdout.readline() if wait else ""
        if wait not in line:
            raise AssertionError(f"{words} said {line!r} {process.stderr.read()}")
        process.stated = []
        process.reader = threading.Thread(  # so that nobody waits to be read
            target=lambda: process.stated.append(process.stdout.read()), daemon=True
        )
        process.reader.start()
        return process

    def scheduler(self, host="127.0.0.1", port=0, **more):
        return self.command(
            "scheduler", self.folder, "--host", host, "--port", port, wait="scheduler: tls://", **more
        )  # fmt: skip

    def worker(self, folder=None, jobs=1, **more):
        return self.command(
            "worker", "--cluster", folder or self.folder, "--jobs", jobs, wait="worker of tls://", **more
        )

    @property
    def port(self):
        return int(json.loads((self.folder / "scheduler.json").read_text())["address"].rpartition(":")[2])

    def also_at(self, folder, address):
        """Another folder of the same cluster, whose scheduler is reached elsewhere."""
        shutil.copytree(self.folder, folder)
        facts = json.loads((folder / "scheduler.json").read_text())
        (folder / "scheduler.json").write_text(json.dumps({**facts, "address": address}))
        return folder

    def close(self):
        for process in reversed(self.running):
            end(process)


def end(process):
    """Kill what was begun, with all processes that it began."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    if hasattr(process, "reader"):
        process.reader.join()
    process.stdout.close()
    process.stderr.close()


def processes_of(process):
    """Processes that a worker's command has begun and that do tasks."""
    import psutil

    with contextlib.suppress(psutil.NoSuchProcess):
        children = psutil.Process(process.pid).children(recursive=True)
        return [c for c in children if "spawn_main" in " ".join(c.cmdline())]
    return []


class Line:
    """A line to a port of this machine that can be cut: what goes over it ends at once, and nobody gets through."""

    def __init__(self, port):
        self.port, self.open, self.ends = port, True, []
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.address = f"tls://127.0.0.1:{self.listening.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        with contextlib.suppress(OSError):
            while True:
                here, _ = self.listening.accept()
                if not self.open:
                    here.close()
                    continue
                with contextlib.suppress(OSError):
                    there = socket.create_connection(("127.0.0.1", self.port))
                    self.ends += [here, there]
                    for one, other in ((here, there), (there, here)):
                        threading.Thread(target=self._carry, args=(one, other), daemon=True).start()

    @staticmethod
    def _carry(one, other):
        with contextlib.suppress(OSError):
            while data := one.recv(1 << 16):
                other.sendall(data)
        for end_ in (one, other):
            with contextlib.suppress(OSError):
                end_.shutdown(socket.SHUT_RDWR)

    def cut(self):
        self.open = False
        for end_ in self.ends:
            with contextlib.suppress(OSError):
                end_.shutdown(socket.SHUT_RDWR)
            end_.close()
        self.ends = []

    def close(self):
        self.cut()
        self.listening.close()
