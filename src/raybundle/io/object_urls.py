"""What lies at a URL, by fsspec: the only module that knows it."""

from __future__ import annotations

import re
from typing import Any
from urllib.parse import urlsplit

from raybundle.errors import InputError
from raybundle.io.copies import StoreLost

TRIES, PAUSE_S = 3, 0.5
"""Times that something is tried, and the pause before the second, doubled before each further one."""
SILENT_S = 30.0
"""Seconds without a byte after which a web server is given up"""
APPEARS_WHOLE = {
    "s3", "s3a", "gs", "gcs", "az", "abfs", "abfss", "adl", "oss", "ocilake", "oci", "tos", "obs", "hf", "memory",
}  # fmt: skip
"""Protocols under which nobody sees an object before all of it was sent."""
PACKAGES = {
    "s3": "s3fs", "s3a": "s3fs", "gs": "gcsfs", "gcs": "gcsfs", "az": "adlfs", "abfs": "adlfs", "abfss": "adlfs",
    "adl": "adlfs", "oss": "ossfs", "oci": "ocifs", "hf": "huggingface_hub", "sftp": "paramiko", "ssh": "paramiko",
    "http": "aiohttp", "https": "aiohttp",
}  # fmt: skip
"""What brings a protocol."""
WEB = {"http", "https"}
"""Protocols by which something is read and nothing kept"""
SCHEMES = {*APPEARS_WHOLE, *PACKAGES, "file", "local"} - WEB
"""Protocols of stores.  Others of fsspec read what a URL names as instructions (reference), or have no folders."""
REFUSED = re.compile(r"credential|forbidden|unauthori[sz]ed|access ?denied|authentication|\b40[13]\b", re.IGNORECASE)
"""In what a service states that lets nobody in"""


def opened(url: str) -> tuple[Any, str]:
    """File system and path of a URL; raises InputError."""
    try:
        import fsspec.core
    except ImportError:
        raise InputError("store.package_missing", package="fsspec") from None
    if urlsplit(url).password:
        raise InputError(
            "store.secret",
            file=urlsplit(url)._replace(netloc=urlsplit(url).hostname or "").geturl(),
        )
    try:
        fs, root = fsspec.core.url_to_fs(url, use_listings_cache=False, **_patience(url))  # others write there
    except ImportError as error:
        package = PACKAGES.get(urlsplit(url).scheme, "")
        raise StoreLost("store.service_package", detail=reason(error), package=package or "-", file=url) from None
    except ValueError as error:
        raise StoreLost("store.invalid_url", detail=reason(error), file=url) from None
    except Exception as error:  # noqa: BLE001  (some ask their service already)
        raise StoreLost("store.not_reachable", detail=reason(error), file=url) from None
    root = root.rstrip("/")
    if not root and not url.startswith("memory:"):
        raise InputError("store.no_bucket_name", file=url)
    return fs, root


def _patience(url: str) -> dict[str, Any]:
    """Options of a web server: one that falls silent is tried again, however long all of a file takes."""
    if urlsplit(url).scheme not in WEB:
        return {}
    import aiohttp

    return {"client_kwargs": {"timeout": aiohttp.ClientTimeout(total=None, sock_connect=SILENT_S, sock_read=SILENT_S)}}


def reason(error: BaseException) -> str:
    """What a service states, in its words."""
    stated = str(getattr(error, "strerror", None) or error).strip().partition("\n")[0]
    return stated or "no reason is given"
