"""Damage to files: bytes, words and structure changed, seeded, so that an input is known by its number."""

import json
import random
import re
import struct

WORDS = (
    "nan", "inf", "-inf", "NaN", "Infinity", "-1", "0", "-0", "1", "2", "3", "0.5", "1e5", "1e10", "-1e10", "1e20",
    "1e154", "1e308", "-1e308", "1e-308", "5e-324", "1e999", "1e-400", "1_000", "0x10", "true", "null", "[]", "{}",
    "1,5", "1.2.3", "1e", "--1", ".", "2147483648", "4294967296", "9223372036854775808", "18446744073709551616", "",
    '""', "1" * 5000, "9" * 20, "\uff11\uff12", "\u0663",
)  # fmt: skip
PIECES = (
    b"\0", b"\r", b"\n", b"\r\n", b'"', b"'", b",", b";", b"\t", b" ", b"[", b"]", b"{", b"}", b"[[", b"=", b":", b"#",
    b"<", b">", b"</", b"&", b"&#0;", b"<![CDATA[", b"<!--", b"../", b"/", b"\\", b"\xff", b"\xef\xbb\xbf", b"\xff\xfe",
    "\u2028".encode(), "\u202e".encode(), b"\xed\xa0\x80", b"%s", b"{0}", b"\x1a", b"\x1b[2J", b"\x7f", b"x" * 3000,
)  # fmt: skip
WHOLE = (0, 1, 2, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 1 << 40, (1 << 63) - 1)
REAL = (float("nan"), float("inf"), -1e308, 1e308, 0.0, 5e-324, 1e154, -1.0, 1e20)
VALUES = (
    None, True, 0, -1, 1, 1e308, 1e-320, 10**30, float("nan"), "", "x", "\0", "nan", [], {}, [[]], [None], {"a": 1},
    [1, 2], [1, 2, 3], 2**31, 2**64, "../../x", "a\nb", "\u202e", "0" * 500, [[1, 2], [3]], [[[[1]]]], "y" * 5000,
)  # fmt: skip
NUMBER = re.compile(rb"[-+]?[0-9]+\.?[0-9]*(?:[eE][-+]?[0-9]+)?")
TAG = re.compile(rb"<([A-Za-z_][\w:.-]*)([^<>]*)>")


def damaged(rng: random.Random, data: bytes, name: str) -> bytes:
    """One or two changes of a kind that its contents invite."""
    for _ in range(rng.choice((1, 1, 2))):
        ways = [some_bytes]
        if b"\0" not in data[:4000]:
            ways += [numbers, numbers, lines, lines]
        if name.endswith((".json", ".opf", ".gltf", ".model")) or data[:1] in b"{[":
            ways += [tree] * 4
        if TAG.match(data.lstrip()[:200]):
            ways += [elements] * 4
        data = rng.choice(ways)(rng, data)
    return data


def some_bytes(rng, data):
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 4, 12))):
        if not out:
            return rng.choice(PIECES)
        at = rng.randrange(min(len(out), rng.choice((16, 64, 512, len(out), len(out)))))
        way = rng.randrange(8)
        if way == 0:
            out[at] ^= 1 << rng.randrange(8)
        elif way == 1:
            del out[at : at + rng.choice((1, 2, 4, 8, 100, 5000))]
        elif way == 2:
            out[at:at] = rng.choice(PIECES)
        elif way == 3:
            out[at:at] = rng.randbytes(rng.choice((1, 4, 64)))
        elif way == 4:
            out = out[:at] if rng.random() < 0.6 else out[at:]
        elif way == 5:
            begin = rng.randrange(len(out))
            out[at:at] = out[begin : begin + rng.choice((1, 8, 200, 4000))]
        elif way == 6:
            width = rng.choice((1, 2, 4, 8))
            word = rng.choice(WHOLE) & ((1 << 8 * width) - 1)
            out[at : at + width] = word.to_bytes(width, rng.choice(("little", "big")))
        else:
            out[at : at + 8] = struct.pack(rng.choice("<>") + "d", rng.choice(REAL))
    return bytes(out)


def numbers(rng, data):
    found = list(NUMBER.finditer(data))
    if not found:
        return some_bytes(rng, data)
    chosen = rng.sample(found, min(len(found), rng.choice((1, 1, 2, 4))))
    for match in sorted(chosen, key=lambda m: -m.start()):
        data = data[: match.start()] + rng.choice(WORDS).encode() + data[match.end() :]
    return data


def lines(rng, data):
    rows = data.split(b"\n")
    for _ in range(rng.choice((1, 1, 2, 5))):
        if not rows:
            rows = [b""]
        k, other, way = rng.randrange(len(rows)), rng.randrange(len(rows)), rng.randrange(6)
        if way == 0:
            del rows[k]
        elif way == 1:
            rows.insert(k, rows[other])
        elif way == 2:
            rows[k], rows[other] = rows[other], rows[k]
        else:
            mark = rng.choice((b",", b"\t", b" ", b"=", b";"))
            cells = rows[k].split(mark)
            j = rng.randrange(len(cells))
            if way == 3:
                cells[j] = rng.choice((*(w.encode() for w in WORDS), *PIECES))
            elif way == 4:
                del cells[j]
            else:
                cells.insert(j, rng.choice(rows[other].split(mark)))
            rows[k] = mark.join(cells)
    return b"\n".join(rows)


def places(value, way=()):
    yield way
    if isinstance(value, dict):
        for key, below in value.items():
            yield from places(below, (*way, key))
    elif isinstance(value, list):
        for key, below in enumerate(value[:40]):
            yield from places(below, (*way, key))


def tree(rng, data):
    try:
        top = json.loads(data.decode("utf-8-sig"))
    except ValueError:
        return numbers(rng, data)
    for _ in range(rng.choice((1, 1, 2, 4))):
        ways = [w for w in places(top) if w]
        if not ways:
            break
        *above, last = rng.choice(ways)
        parent = top
        for key in above:
            parent = parent[key]
        kind = rng.randrange(4)
        if kind <= 1:
            parent[last] = json.loads(json.dumps(rng.choice(VALUES)))
        elif kind == 2:
            del parent[last]
        elif isinstance(parent, list):
            parent.insert(last, json.loads(json.dumps(parent[last])))
        else:
            parent[rng.choice(("x", "", f"{last}2"))] = parent[last]
    return json.dumps(top).encode()


def elements(rng, data):
    for _ in range(rng.choice((1, 1, 2))):
        found = list(TAG.finditer(data))
        if not found:
            break
        tag = rng.choice(found)
        closing = b"</" + tag[1] + b">"
        end = data.find(closing, tag.end())
        way = rng.randrange(5)
        if end < 0:
            data = data[: tag.start()] + data[tag.end() :]
        elif way == 0:
            data = data[: tag.start()] + data[end + len(closing) :]
        elif way == 1:
            whole = data[tag.start() : end + len(closing)]
            data = data[: tag.start()] + whole + data[tag.start() :]
        elif way == 2:
            data = data[: tag.end()] + rng.choice(WORDS).encode() + data[end:]
        elif way == 3:
            data = data[: tag.end()] + data[end:]
        else:
            name = rng.choice(found)[1]
            data = (
                data[: tag.start()]
                + b"<"
                + name
                + b">"
                + data[tag.end() : end]
                + b"</"
                + name
                + b">"
                + data[end + len(closing) :]
            )
    return data
