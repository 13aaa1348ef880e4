"""Time of the words of messages: import, all entries parsed at once, one entry written for the first time.

python benchmarks/words_parsing.py
"""

from __future__ import annotations

import time

from raybundle import words
from raybundle.words.catalogue import entries


def main() -> None:
    """Print CPU seconds."""
    begin = time.process_time()
    from fluent.runtime import FluentResource

    loaded = time.process_time()
    found = entries(words.ENGLISH)
    read = time.process_time()
    first = words.codes()[0]
    words.sentences(first, words.examples(first))
    written = time.process_time()
    for code in words.codes()[1:]:
        words.sentences(code, words.examples(code))
    each = (time.process_time() - written) / (len(words.codes()) - 1)
    begun = time.process_time()
    FluentResource("\n".join(e.text for e in found.values()))
    parsed = time.process_time() - begun
    print(f"import {loaded - begin:.3f} s, {len(found)} entries found {read - loaded:.3f} s")
    print(f"first message {written - read:.3f} s, each of the others {1e3 * each:.2f} ms, all parsed {parsed:.3f} s")


if __name__ == "__main__":
    main()
