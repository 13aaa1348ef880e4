"""Invented products of Envisat and ERS, written from the specifications' field positions; independent of their readers.

N1: PO-RS-MDA-GS-2009, volume 8, and the ASAR Product Handbook, 6.6; positions as GDAL's frmts/envisat/records.c and
SNAP's ASAR_*.dd have them.  CEOS: ER-IS-EPO-GS-5902; positions as the XML of ISCE (db/ers_slc) and SNAP have them.
"""

import struct
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tests.scenes.radar_products import START, TARGET, C, Product

HEIGHT_M = 300.0
MONTHS = ["JAN", "FEB", "MAR", "APR", "MAY", "JUN", "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"]
MDS, UNUSED = "MDS1", "MDS2"


@dataclass(kw_only=True)
class Esa(Product):
    """A product of 16 s and five state vectors, its numbers those that single precision, or the file's digits, hold."""

    columns: int = 5000
    rows: int = 20001
    line_s: float = 0.0008
    spacing_m: float = 7.8
    vectors: int = 5
    step_s: float = 4.0
    single: bool = True

    def __post_init__(self):
        super().__post_init__()
        if not self.ground:
            rate = C / 2 / self.spacing_m
            self.rate = float(np.float32(rate)) if self.single else round(rate * 1e-6, 7) * 1e6
            self.spacing_m = C / 2 / self.rate
        else:
            self.rate = 19e6
        time = 2 * self.near_m / C
        time = float(np.float32(time * 1e9)) * 1e-9 if self.single else round(time * 1e3, 7) * 1e-3
        self.near_m = C / 2 * time

    def sets(self):
        times, rows = super().sets()
        rows[:, 0] = self.near_m + 9.0 * np.arange(len(rows))
        return times, rows.astype(np.float32).astype(float) if self.single else rows

    def pixels(self, columns, rows, height=HEIGHT_M):
        """Ground points (n, 3) of pixels that count from 0 at centres, by secants over their image points."""
        wanted = np.array([(x, y) for y in rows for x in columns], float) + 0.5
        place = np.tile([*TARGET[:2], height], (len(wanted), 1))
        for _ in range(12):
            at = self.project(place)[2]
            steps = np.stack([self.project(place + d)[2] - at for d in np.diag([1e-4, 1e-4, 0])[:2]], axis=2) / 1e-4
            place[:, :2] += np.linalg.solve(steps, (wanted - at)[..., None])[..., 0]
        return place, wanted

    def table(self):
        """State vectors from the first to the last line."""
        half = (self.rows - 1) * self.line_s / 2
        t = np.linspace(-half, half, self.vectors)
        return t, *self.at(t)


def put(record, offset, layout, *values):
    struct.pack_into(">" + layout, record, offset, *values)


def mjd(record, offset, t):
    micro = round((START - np.datetime64("2000-01-01", "us")) / np.timedelta64(1, "us") + t * 1e6)
    put(record, offset, "iII", micro // 86_400_000_000, micro // 1_000_000 % 86400, micro % 1_000_000)


def n1(p, kind="IMS", *, granules=4, level="1P", pad=0):
    """The file up to its image, and exact ground and image points of its geolocation grid."""
    samples = np.round(np.linspace(1, p.columns, 11)).astype(int)
    starts = np.round(np.linspace(1, p.rows + 1, granules + 1)).astype(int)
    lines = [(a, b - 1) for a, b in pairwise(starts.tolist())]
    ground, image = p.pixels(samples - 1, [line - 1 for pair in lines for line in pair])
    times, ranges, _ = p.project(ground)
    grid = b""
    for k, (a, b) in enumerate(lines):  # ASAR Product Handbook 6.6.9: geolocation grid ADSR, 521 bytes
        record = bytearray(521)
        put(record, 13, "II", a, b - a + 1)
        for row, at, at_time in ((2 * k, 25, 0), (2 * k + 1, 279, 267)):
            own = slice(11 * row, 11 * row + 11)
            mjd(record, at_time, times[own][0])
            put(record, at, "11I", *samples.tolist())
            put(record, at + 44, "11f", *(2e9 / C * ranges[own]))
            put(record, at + 132, "11i", *np.round(ground[own, 1] * 1e6).astype(int).tolist())
            put(record, at + 176, "11i", *np.round(ground[own, 0] * 1e6).astype(int).tolist())
        grid += bytes(record)
    main = bytearray(2009 + pad)  # 6.6.12: main processing parameters ADSR
    last_s = p.first_s + (p.rows - 1) * p.line_s * (1 if p.forwards else -1)
    mjd(main, 0, p.first_s)
    mjd(main, 13, last_s)
    put(main, 41, "3sfffII5s", b"IS2", p.spacing_m, 4.0, p.line_s, p.rows, p.columns, b"UWORD")
    put(main, 123, "B", int(p.ground))
    put(main, 983, "ff", p.rate, 5.331e9)
    put(main, 1541, "f", HEIGHT_M)
    for k, (t, P, V) in enumerate(zip(*p.table(), strict=True)):
        mjd(main, 1765 + 36 * k, t)
        put(main, 1777 + 36 * k, "6i", *np.round(P * 100).astype(int).tolist(), *np.round(V * 1e5).astype(int).tolist())
    conversion = b""
    for t, c in zip(*p.sets(), strict=True) if p.ground else ():  # 6.6.16: slant to ground range ADSR, 55 bytes
        record = bytearray(55)
        mjd(record, 0, t)
        put(record, 13, "ff5f", 2e9 / C * p.near_m, 0.0, *c, 0.0)
        conversion += bytes(record)
    sets = [("MDS1 SQ ADS", "A", bytes(170), 170), ("MAIN PROCESSING PARAMS ADS", "A", bytes(main), len(main)),
            ("DOP CENTROID COEFFS ADS", "A", bytes(55), 55), ("SR GR ADS", "A", conversion, 55),
            ("GEOLOCATION GRID ADS", "A", grid, 521)]  # fmt: skip
    pixel = p.columns * (2 if p.ground else 4) + 17
    head = "\n".join([
        f'SPH_DESCRIPTOR="{"Image Mode SLC Image":28}"', 'SWATH="IS2"', f"LINE_LENGTH=+{p.columns:05}<samples>",
        f"LINE_TIME_INTERVAL={p.line_s:+.8E}<s>", f'SAMPLE_TYPE="{"DETECTED" if p.ground else "COMPLEX "}"',
        f'DATA_TYPE="{"UWORD" if p.ground else "SWORD"}"', " " * 50, "",
    ])  # fmt: skip
    at = 1247 + len(head) + 280 * (len(sets) + 2)
    body = b""
    for name, what, data, size in sets:
        head += descriptor(name, what, at + len(body) if data else 0, len(data), size if data else 0)
        body += data
    head += descriptor(MDS, "M", at + len(body), p.rows * pixel, pixel) + descriptor(UNUSED, "M", 0, 0, 0)
    return main_header(f"ASA_{kind}_{level}", len(head), len(sets) + 2) + head.encode() + body, ground, image


def descriptor(name, what, offset, size, record):
    """A data set descriptor of 280 bytes."""
    text = (
        f'DS_NAME="{name:28}"\nDS_TYPE={what}\nFILENAME="{"" if size else "NOT USED":62}"\n'
        f"DS_OFFSET=+{offset:020}<bytes>\nDS_SIZE=+{size:020}<bytes>\nNUM_DSR=+{size // record if record else 0:010}\n"
        f"DSR_SIZE=+{record:010}<bytes>\n{'':32}\n"
    )
    assert len(text) == 280
    return text


def main_header(product, size, sets):
    """The main product header of 1247 bytes; its lines have fixed lengths."""
    text = (
        f'PRODUCT="{product + "NESA20230506_170552_000000162028_00172_12250_0000.N1":62}"\nPROC_STAGE=N\n'
        f'REF_DOC="{"PO-RS-MDA-GS-2009_4/C":23}"\n'
    )
    end = (
        f"TOT_SIZE=+{0:020}<bytes>\nSPH_SIZE=+{size:010}<bytes>\nNUM_DSD=+{sets:010}\nDSD_SIZE=+{280:010}<bytes>\n"
        f"NUM_DATA_SETS=+{sets:010}\n{'':40}\n"
    )
    return (text + " " * (1247 - len(text) - len(end) - 1) + "\n" + end).encode()


def ceos_record(number, codes, length):
    record = bytearray(b" " * length)
    put(record, 0, "IBBBBI", number, *codes, length)
    return record


def field(record, first, last, text):
    """Characters of a field, right-justified, at bytes that count from 1."""
    text = str(text)
    assert len(text) <= last - first + 1, (first, text)
    record[first - 1 : last] = text.rjust(last - first + 1).encode()


def clock(t):
    time = str(START + np.timedelta64(round(t * 1e6), "us"))
    date, hour = time.split("T")
    year, month, day = date.split("-")
    return f"{day}-{MONTHS[int(month) - 1]}-{year} {hour[:12]}"


def leader(p, *, vmp=False, inertial=None, late_s=0.0, kind=None, mission="ERS2", projection=None, mm=1.0):
    """LEA_01.001, and exact ground and image points of its corners.

    inertial  Greenwich hour angle [rad] at the first state vector, which then stands in an inertial frame
    late_s    of the state vectors after the lines
    """
    slant = not p.ground
    descriptor_ = ceos_record(1, (63, 192, 18, 18), 720)
    field(descriptor_, 49, 64, "ERS2.SAR.SLCLEAD")
    summary = ceos_record(2, (10, 10, 31, 20), 1886)  # data set summary record
    field(summary, 397, 412, mission.ljust(16))
    field(summary, 477, 484, f"{90 * p.side:.3f}")
    field(summary, 501, 516, "0.0566660")
    field(summary, 711, 726, f"{p.rate * 1e-6:.7f}")
    field(summary, 935, 950, f"{1 / p.line_s:.7f}")
    kind = kind or ("SAR SINGLE LOOK COMPLEX IMAGE" if slant else "SAR PRECISION IMAGE")
    field(summary, 1111, 1142, kind.ljust(32))
    span = (p.columns - 1) * p.spacing_m * np.array([0.0, 0.5, 1.0])
    ranges = (p.near_m + span if slant else p.slant(span, np.zeros(3)))[:: 1 if p.near_first else -1]
    for k, R in enumerate(ranges):
        field(summary, 1767 + 16 * k, 1782 + 16 * k, f"{2e3 * R / C:.7f}")
    last_s = p.first_s + (p.rows - 1) * p.line_s * (1 if p.forwards else -1)
    for k, t in enumerate((p.first_s, (p.first_s + last_s) / 2, last_s)):
        field(summary, 1815 + 24 * k, 1838 + 24 * k, clock(t))
    ground, image = p.pixels([0, p.columns - 1], [0, p.rows - 1], 0.0)
    map_ = ceos_record(3, (10, 20, 31, 20), 1620)  # map projection data record
    field(map_, 29, 60, (projection or ("Slant range" if slant else "Ground range")).ljust(32))
    field(map_, 61, 76, f"{p.columns:<16}")
    field(map_, 77, 92, f"{p.rows:<16}")
    field(map_, 93, 108, f"{p.spacing_m:.7f}")
    for k, corner in enumerate(ground[[0, 1, 3, 2]]):
        for j in (0, 1):
            field(map_, 1073 + 32 * k + 16 * j, 1088 + 32 * k + 16 * j, f"{corner[1 - j]:.7f}")
    platform = ceos_record(4, (10, 30, 31, 20), 386 + 132 * p.vectors)  # platform position data record
    t, P, V = p.table()
    t = t + late_s
    P, V = p.at(t)
    if inertial is not None:
        rate = 7.2921151467e-5
        V = V + rate * np.cross([0.0, 0.0, 1.0], P)
        a = inertial + rate * (t - t[0])
        c, s = np.cos(a), np.sin(a)
        P, V = (np.stack([c * v[:, 0] - s * v[:, 1], s * v[:, 0] + c * v[:, 1], v[:, 2]], axis=1) for v in (P, V))
        field(platform, 269, 290, f"{np.degrees(inertial):.15E}")
    at = START + np.timedelta64(round(t[0] * 1e6), "us")
    day = at.astype("datetime64[D]")
    date = str(day).split("-")
    field(platform, 141, 144, f"{p.vectors:04}")
    field(platform, 145, 156, f"{date[0]:>4}{int(date[1]):4}{int(date[2]):4}")
    field(platform, 161, 182, f"{(at - day) / np.timedelta64(1, 'us') * 1e-6:.15E}")
    field(platform, 183, 204, f"{t[1] - t[0]:.15E}".replace("E", "D"))
    field(platform, 205, 268, ("Earth Centred Rotating" if inertial is None else "INERTIAL").ljust(64))
    for k, v in enumerate(np.concatenate([P, mm * V], axis=1).ravel()):
        field(platform, 387 + 22 * k, 408 + 22 * k, f"{v: .15E}")
    facility = ceos_record(5, (10, 200, 31, 50), 12288)  # facility related data record, general type
    field(facility, 13, 76, "FACILITY RELATED DATA RECORD [ESA GENERAL TYPE]".ljust(64))
    if p.ground:
        c = p.sets()[1][0].copy()
        if vmp:  # samples from the nearest one
            c[0] -= p.near_m
            c *= 2 * p.rate / C
        for k, v in enumerate(c):
            field(facility, 1855 + 20 * k, 1874 + 20 * k, f"{v:.12E}")
    return b"".join(bytes(r) for r in (descriptor_, summary, map_, platform, facility)), ground, image


def data_file(p, rows=None, columns=None):
    """DAT_01.001 of a complex image, its lines where they are few."""
    rows, columns = rows or p.rows, columns or p.columns
    record = ceos_record(1, (63, 192, 18, 18), 720)
    layout = ((225, 228, 4), (233, 236, 1), (237, 244, rows), (249, 256, columns), (269, 272, "BSQ"), (273, 274, 1),
              (277, 280, 12), (289, 292, 0), (429, 432, "CI*4"))  # fmt: skip
    for first, last, value in layout:
        field(record, first, last, value)
    length = 12 + 4 * columns
    lines = [ceos_record(k + 2, (50, 11, 18, 20), length) for k in range(rows)] if rows < 100 else []
    return b"".join(bytes(r) for r in (record, *lines))


def radarsat1(p, *, sets=None, bytes_=2):
    """LEA_01.001 and DAT_01.001 of RADARSAT-1 (CDPF RZ-SP-50-5313); exact ground and image points of its lines.

    Fields of the detailed processing parameters: 7726 bytes, as ASF's and OSSIM's structures have them.
    """
    head = leader(p, mission="RSAT-1", inertial=1.0, mm=1e3, kind="SGF")[0]
    detailed = ceos_record(6, (18, 120, 18, 20), 7726)
    times, rows = p.sets()
    field(detailed, 4883, 4886, len(times) if sets is None else sets)
    for k, (t, c) in enumerate(zip(times, rows, strict=True)):
        at = 4887 + 117 * k
        time = START + np.timedelta64(round(t * 1e6), "us")
        day = (time.astype("datetime64[D]") - time.astype("datetime64[Y]").astype("datetime64[D]")).astype(int) + 1
        field(detailed, at, at + 20, f"{str(time)[:4]}-{day:03}-{str(time)[11:23]}")
        for j, v in enumerate([*c, 0.0, 0.0]):
            field(detailed, at + 21 + 16 * j, at + 36 + 16 * j, f"{v:.9E}")
    field(detailed, 7227, 7242, f"{p.spacing_m:.7f}")
    middle, lines = (p.columns - 1) / 2, np.arange(p.rows)
    ground, image = p.pixels([0, middle, p.columns - 1], [0, p.rows // 2, p.rows - 1], 0.0)
    near_first = np.array([0.0, middle, p.columns - 1.0]) if p.near_first else np.array([p.columns - 1.0, middle, 0.0])
    t = p.first_s + lines * p.line_s * (1 if p.forwards else -1)
    size = 192 + 2 * p.columns
    data = bytearray(data_file(p, p.rows, p.columns)[:720])
    field(data, 225, 228, bytes_)
    every = p.pixels([0, middle, p.columns - 1], lines, 0.0)[0].reshape(-1, 3, 3)
    body = b""
    for k, seconds in enumerate(t):
        line = bytearray(size)
        put(line, 0, "IBBBBI", k + 2, 50, 11, 18, 20, size)
        at = START + np.timedelta64(round(seconds * 1e3), "ms")
        year = at.astype("datetime64[Y]").astype("datetime64[ms]")
        days, ms = divmod(int((at - year) / np.timedelta64(1, "ms")), 86_400_000)
        put(line, 36, "3I", int(str(at)[:4]), days + 1, ms)
        ranges = p.slant(near_first * p.spacing_m, np.full(3, seconds))
        put(line, 64, "3I", *np.round(ranges).astype(int).tolist())
        put(line, 132, "6i", *np.round(every[k, :, [1, 0]] * 1e6).astype(int).ravel().tolist())
        body += bytes(line)
    return head, bytes(detailed), bytes(data) + body, ground, image
