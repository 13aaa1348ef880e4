"""The cells of CSV lines."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator

from raybundle.errors import Message, message


class BadRow(Exception):
    """A line that is no row of a table, with its number counted from 0."""

    def __init__(self, position: int, problem: Message) -> None:
        super().__init__(problem.code)
        self.position, self.problem = position, problem


def cells_of(lines: Iterable[str], separator: str = ",") -> Iterator[list[str]]:
    """The cells of each line; raises BadRow where one cannot be read, also where a quoted cell goes over its end."""
    reader = csv.reader(lines, strict=True, delimiter=separator)
    position = 0
    while True:
        try:
            row = next(reader)
        except StopIteration:
            return
        except csv.Error as error:
            raise BadRow(position, message("table.row_unreadable", detail=str(error))) from None
        if reader.line_num != position + 1:
            raise BadRow(position, message("table.quote_open"))
        yield row
        position += 1
