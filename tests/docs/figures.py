"""Numbers of pages, whatever words stand between them."""

import re


def in_a_row(text: str, *numbers: str) -> bool:
    """Whether these numbers stand in a text one after the other, with no other number between."""
    found = re.findall(r"\d+(?:\.\d+)?", text)
    return any(found[k : k + len(numbers)] == [*numbers] for k in range(len(found)))
