"""Counts in sentences."""

from __future__ import annotations


def grouped(number: int) -> str:
    """A whole number in groups of three digits: 18 803."""
    return f"{number:,}".replace(",", " ")


def counted(number: int, noun: str) -> str:
    """A number and its noun: "1 image", "18 803 images"."""
    return f"{grouped(number)} {noun}{'' if number == 1 else 's'}"


def counted_are(number: int, noun: str) -> str:
    """The same as the subject of a sentence: "1 image is", "3 images are"."""
    return f"{counted(number, noun)} {'is' if number == 1 else 'are'}"
