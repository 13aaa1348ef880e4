"""What a limit of memory does is reported as such."""

import pytest
from tests.blocking.networks import flight

from raybundle.cli.failures import failure_lines
from raybundle.workflows.within_memory import BASE, within_memory


@pytest.mark.parametrize(
    "error",
    [
        MemoryError(), ImportError("libssl.so.3: failed to map segment from shared object"),
        ImportError("libx.so: cannot allocate memory in static TLS block"),
        ImportError("libx.so: Cannot allocate memory"), RuntimeError("can't start new thread"),
    ],
    ids=str,
)  # fmt: skip
def test_refused_memory_is_no_internal_error(error):
    said, status = failure_lines(error)
    assert status == 2
    assert said.startswith("MemoryError: ")


@pytest.mark.parametrize("error", [ImportError("no module"), RuntimeError("x"), ValueError("can't start new thread")])
def test_other_errors_stay(error):
    assert failure_lines(error)[1] == 1


@pytest.mark.parametrize(
    ("allowed_gb", "codes"), [(0.001, ["memory_exceeded"]), (1e-6, ["memory_exceeded"]), (0.0, [])]
)
def test_less_memory_than_the_program_takes_is_noticed(tmp_path, allowed_gb, codes):
    with within_memory(flight(), tmp_path / "r", allowed_gb) as (_, room):
        assert (room.allowed < BASE) == bool(codes)
    assert [n.code for n in room.notices()] == codes
