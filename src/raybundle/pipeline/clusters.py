"""Where a cluster is: a folder that its machines share, with the scheduler's address and the certificates.

    CLUSTER/scheduler.json  address of the scheduler and what it runs, written when it starts (Dask's scheduler file)
    CLUSTER/ca.pem          certificate by which scheduler, workers and who asks them know each other
    CLUSTER/cert.pem        that of the cluster's own machines
    CLUSTER/key.pem         its key: whoever reads it may run programs on the workers

An address alone is for a scheduler on this machine: what goes over a network is encrypted, and both ends are known.
"""

from __future__ import annotations

import datetime as dt
import hashlib
import ipaddress
import json
import os
import platform
import secrets
import socket
import ssl
import time
import uuid
from contextlib import ExitStack
from dataclasses import dataclass
from functools import lru_cache
from importlib import metadata
from pathlib import Path
from urllib.parse import urlsplit

from raybundle.errors import InputError, phrase
from raybundle.io.reading.trees import read_json
from raybundle.numerics import native
from raybundle.pipeline.store import Folder, store_at, writing

SCHEDULER = "scheduler.json"
CERTIFICATES = ("ca.pem", "cert.pem", "key.pem")
TOKEN = "token"  # noqa: S105  (of a folder, no secret)
"""File of a store by which a worker knows that it sees the same one."""
ANSWER_S = 10.0
"""Within which a scheduler answers: some hundred times what a busy one takes."""
APPEAR_S = 60.0
"""Within which a file that one machine wrote is seen by another: NFS asks again after at most so long (acdirmax)."""
MATTERS = ("numpy", "scipy", "opencv-python-headless", "poselib")
"""Distributions beside raybundle by which results may differ in their last digits."""


class NoScheduler(InputError):
    """No scheduler is there, or it does not answer: one may come."""

    @property
    def why(self) -> str:
        """What is wrong, after its place."""
        return self.headline


@dataclass(frozen=True, slots=True)
class Cluster:
    """A scheduler and how it is reached."""

    address: str
    folder: Path | None = None
    """of the certificates; None: not encrypted, on this machine alone"""
    runs: str = ""
    """`signature` of the scheduler's raybundle; empty: not stated"""

    @property
    def files(self) -> tuple[Path, ...]:
        """Certificate of the authority, certificate, key."""
        return () if self.folder is None else tuple(self.folder / name for name in CERTIFICATES)


def cluster_at(where: str) -> Cluster:
    """The cluster of a folder or an address; raises InputError where it is none, or would not be safe."""
    if "://" in where:
        try:
            host = urlsplit(where).hostname or ""
        except ValueError:
            raise InputError("cluster.no_address", address=where, file=where) from None
        if not _is_loopback(host):
            raise InputError(
                "cluster.other_machine",
                file=where,
            )
        if not where.startswith("tcp://"):
            raise InputError("cluster.needs_certificates", file=where)
        return _checked(Cluster(where), where)
    folder = Path(where)
    file = folder / SCHEDULER
    if not file.is_file():
        raise NoScheduler("cluster.no_scheduler", file_name=SCHEDULER, folder=str(folder), file=folder)
    tree = read_json(file)
    found = Cluster(tree.get("address").text(), folder, tree.get("raybundle").text() if tree.has("raybundle") else "")
    missing = [f.name for f in found.files if not f.is_file()]
    if missing:
        others = [name for name in CERTIFICATES if name not in missing]
        raise InputError("cluster.certificates_missing", names=missing, others=others, n=len(others), file=folder)
    if not found.address.startswith("tls://"):
        raise InputError("cluster.not_encrypted", address=found.address, file=file)
    return _checked(found, str(file))


def _checked(cluster: Cluster, where: str) -> Cluster:
    """The same; raises InputError for an address that has no host or port."""
    try:
        parts = urlsplit(cluster.address)
        if parts.hostname and parts.port:
            return cluster
    except ValueError:
        pass
    raise InputError("cluster.no_address", address=cluster.address, file=where)


def _is_loopback(host: str) -> bool:
    """Whether an address cannot be reached from elsewhere."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def write_scheduler(folder: Path, address: str) -> None:
    """Say in a cluster's folder where its scheduler is, whole or not at all."""
    with writing(folder):
        temporary = folder / f".{SCHEDULER}.{uuid.uuid4().hex[:8]}"
        try:
            temporary.write_text(json.dumps({"address": address, "raybundle": signature()}) + "\n", encoding="utf-8")
            temporary.replace(folder / SCHEDULER)
        finally:
            temporary.unlink(missing_ok=True)


def check_certificates(folder: Path) -> None:
    """Raise InputError for certificates that are none, or whose time is over."""
    from cryptography.x509 import load_pem_x509_certificate

    for name in CERTIFICATES[:2]:
        try:
            until = load_pem_x509_certificate((folder / name).read_bytes()).not_valid_after_utc
        except (OSError, ValueError):
            raise InputError("cluster.no_certificate", file=folder / name) from None
        if until < dt.datetime.now(dt.UTC):
            raise InputError("cluster.certificates_expired", date=f"{until:%Y-%m-%d}", file=folder)
    _context(Cluster("", folder))


def check_answers(cluster: Cluster) -> None:
    """Raise InputError where a scheduler does not answer, or does not know our certificate."""
    parts = urlsplit(cluster.address)
    if cluster.folder is not None:
        check_certificates(cluster.folder)
    where = cluster.folder or cluster.address
    try:
        with ExitStack() as stack:
            line: socket.socket = stack.enter_context(
                socket.create_connection((parts.hostname or "", parts.port or 0), ANSWER_S)
            )
            if cluster.folder is not None:
                line = stack.enter_context(_context(cluster).wrap_socket(line))
            if not line.recv(1):  # a scheduler speaks first
                raise ConnectionResetError
    except ssl.SSLCertVerificationError as error:
        raise InputError(
            "cluster.foreign_certificate", address=cluster.address, detail=str(error.reason), file=where
        ) from None
    except ssl.SSLError as error:
        raise InputError(
            "cluster.certificate_refused", address=cluster.address, detail=str(error.reason), file=where
        ) from None
    except TimeoutError:
        raise NoScheduler("cluster.timeout", address=cluster.address, wait_s=ANSWER_S, file=where) from None
    except OSError as error:
        detail = error.strerror or type(error).__name__
        raise NoScheduler("cluster.no_answer", address=cluster.address, detail=detail, file=where) from None


def _context(cluster: Cluster) -> ssl.SSLContext:
    """With the certificates of a cluster, whose names are no hosts' names; raises InputError where they cannot be."""
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
    context.check_hostname = False
    ca, cert, key = cluster.files
    try:
        context.load_verify_locations(ca)
        context.load_cert_chain(cert, key)
    except (OSError, ssl.SSLError) as error:
        raise InputError(
            "cluster.certificates_not_usable",
            detail=str(getattr(error, "strerror", None) or error),
            file=cluster.folder,
        ) from None
    return context


@lru_cache
def signature() -> str:
    """What this raybundle is: version, and a sum over its programs and what its digits depend on beside them."""
    total = hashlib.sha256(f"{platform.python_version().rpartition('.')[0]} {native.available()}".encode())
    for name in MATTERS:
        total.update(f"{name} {metadata.version(name)}\n".encode())
    home = Path(__file__).parents[1]
    for file in sorted(home.rglob("*.py")):
        total.update(file.relative_to(home).as_posix().encode())
        total.update(file.read_bytes())
    return f"raybundle {metadata.version('raybundle')} ({total.hexdigest()[:12]})"


def token_of(store: Folder) -> str:
    """What a store is known by, written the first time that it is asked for."""
    found = store.place.text(TOKEN)
    if found is None:
        store.place.keep_text(TOKEN, secrets.token_hex(16))
        found = store.place.text(TOKEN)
    return found or ""


@lru_cache
def unseen(folder: str, url: str, token: str) -> str:
    """Why a worker does not see a store as others do; empty: it does."""
    until = time.monotonic() + APPEAR_S
    while True:
        try:
            found = store_at(folder, url).place.text(TOKEN)
        except InputError as error:  # it was tried already
            return str(error)
        except (OSError, UnicodeDecodeError) as error:
            found, why = "", getattr(error, "strerror", None) or str(error)
        else:
            why = phrase("cluster.other_store" if found else "cluster.no_store")
        if found == token:
            return "" if url or os.access(folder, os.W_OK) else phrase("cluster.store_read_only")
        if time.monotonic() > until:
            return why
        time.sleep(1.0)
