"""SciPy's BLAS and LAPACK: handed to the native factor, and held to one thread where two would wait for each other."""

from __future__ import annotations

import ctypes
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

from raybundle.numerics import native

SMALL = 1000
"""Unknowns of a full matrix up to which one thread is the quicker, by a hundred times where processors are busy
otherwise."""
PREFIXES = ("scipy_openblas", "openblas")
"""Of the names of OpenBLAS's functions, as in the wheels and as in the distributions."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Threads:
    """How many threads the library takes; other libraries than OpenBLAS have neither."""

    read: Any
    set: Any


@cache
def set_dense_kernels() -> Threads | None:
    """Hand SciPy's BLAS and LAPACK to the native factor; what sets their threads, None where it is not known."""
    blas, lapack = import_module("scipy.linalg.cython_blas"), import_module("scipy.linalg.cython_lapack")
    solver = native.module()
    assert solver is not None
    solver.set_dense(
        _address(lapack, "dpotrf"),
        _address(lapack, "dpotri"),
        _address(blas, "dtrsm"),
        _address(blas, "dsyrk"),
        _address(blas, "dgemm"),
    )
    return _threads_of(lapack)


@cache
def threads_of_numpy() -> Threads | None:
    """What sets the threads of the BLAS that NumPy multiplies with, which its wheels bring for themselves."""
    return _threads_of(import_module("numpy.linalg._umath_linalg"))


def _threads_of(module: Any) -> Threads | None:
    library = ctypes.CDLL(str(module.__file__))  # finds the functions of the library that it is linked to, too
    for prefix in PREFIXES:
        for suffix in ("", "64_"):
            read, set_ = (getattr(library, f"{prefix}_{verb}_num_threads{suffix}", None) for verb in ("get", "set"))
            if read is not None and set_ is not None:
                return Threads(read=read, set=set_)
    return None


@contextmanager
def as_many_threads_as_help(unknowns: int) -> Generator[None]:
    """One thread of BLAS and LAPACK within, for matrices that are small; it holds for the whole process.

    unknowns  of a full matrix, or that an unknown of a sparse one meets
    """
    threads = set_dense_kernels() if unknowns <= SMALL and native.available() else None
    before = 1 if threads is None else int(threads.read())
    if threads is None or before == 1:
        yield
        return
    threads.set(1)
    try:
        yield
    finally:
        threads.set(before)


@contextmanager
def one_thread() -> Generator[None]:
    """One thread of all BLAS and LAPACK within, NumPy's own too, for many products of small matrices.

    It holds for the whole process.  Where processors are busy otherwise a second thread makes them twenty times slower.
    """
    numpys = threads_of_numpy()
    before = 1 if numpys is None else int(numpys.read())
    with as_many_threads_as_help(0):
        if numpys is None or before == 1:
            yield
            return
        numpys.set(1)
        try:
            yield
        finally:
            numpys.set(before)


def _address(module: Any, name: str) -> int:
    """Where a function stands that a Cython module exports."""
    get_name = ctypes.pythonapi.PyCapsule_GetName
    get_name.restype, get_name.argtypes = ctypes.c_char_p, [ctypes.py_object]
    get_pointer = ctypes.pythonapi.PyCapsule_GetPointer
    get_pointer.restype, get_pointer.argtypes = ctypes.c_void_p, [ctypes.py_object, ctypes.c_char_p]
    capsule = module.__pyx_capi__[name]
    return int(get_pointer(capsule, get_name(capsule)) or 0)
