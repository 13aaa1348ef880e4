"""What a result keeps apart from its figures: the factored normal equations, which answer questions later."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from raybundle.adjustment.work import Work


class Handle:
    """The factored normal equations behind a result, for `raybundle.adjustment.queries`.

    A result is plain data and can be copied, kept and sent to another process; its handle stays behind: the copy has an
    empty one, and an error asks for a new adjustment.
    """

    __slots__ = ("work",)

    def __init__(self, work: Work | None = None) -> None:
        """An empty handle, or one of an adjusted system."""
        self.work = work

    def __reduce__(self) -> tuple[type[Handle], tuple[()]]:
        """Of copies: an empty one."""
        return Handle, ()

    def __repr__(self) -> str:
        """Whether it can answer."""
        return "<Handle, empty>" if self.work is None else "<Handle>"


EMPTY = Handle()
