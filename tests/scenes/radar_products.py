"""Products of radar scenes made from an orbit, as the vendors' files state them; independent of their readers.

Image points are solved here by bisection of the Doppler equation on the circular orbit itself, not on its table.
"""

from dataclasses import dataclass, field

import numpy as np

from raybundle.numerics.geodesy import WGS84, enu_from_geocentric, geocentric_from_geographic
from raybundle.scenes.simulate import GM

C = 299792458.0
TARGET = (15.0, 48.0, 300.0)
START = np.datetime64("2023-05-06T17:06:00.000000", "us")


@dataclass(kw_only=True)
class Product:
    """A radar image by its own truth: times of lines and slant ranges of columns are exact in the file's digits."""

    columns: int = 1200
    rows: int = 2000
    forwards: bool = True
    near_first: bool = True
    ground: bool = False
    side: float = 1.0
    vectors: int = 13
    step_s: float = 10.0
    line_s: float = 0.0005
    spacing_m: float = 2.5
    polynomials: int = 1
    off_deg: float = 3.5
    heading_deg: float = 190.0
    linear: bool = False
    timed: bool = False
    delay_s: float = 0.0
    shift_s: float = 0.0
    orbit: tuple = field(init=False)

    def __post_init__(self):
        T = geocentric_from_geographic(np.array([TARGET]), WGS84)[0]
        E, N, _ = enu_from_geocentric(np.array([TARGET]))[0]
        far, heading = np.linalg.norm(T), np.radians(self.heading_deg)
        along = np.sin(heading) * E + np.cos(heading) * N
        along -= T * (along @ T) / far**2
        along /= np.linalg.norm(along)
        turn = -np.radians(self.off_deg) * self.side  # about the direction of flight
        up = T / far
        p0 = up * np.cos(turn) + np.cross(along, up) * np.sin(turn)
        self.orbit = (far + 693e3, p0, along)
        self.near_m = round(float(np.linalg.norm(T - self.orbit[0] * p0)) - self.columns / 2 * self.spacing_m, 3)

    def at(self, t):
        """Position and velocity at times in s after the middle of the image."""
        radius, p0, along = self.orbit
        rate = np.sqrt(GM / radius**3)
        c, s = np.cos(rate * t)[:, None], np.sin(rate * t)[:, None]
        return radius * (c * p0 + s * along), radius * rate * (c * along - s * p0)

    def utc(self, t):
        """A time of the file, in whole microseconds."""
        return f"{START + np.timedelta64(round(t * 1e6), 'us')}Z"

    @property
    def first_s(self):
        """Time of the first line of the image: the centre of its first pixel."""
        half = (self.rows - 1) * self.line_s / 2
        return -half if self.forwards else half

    def table(self):
        t = (np.arange(self.vectors) - (self.vectors - 1) / 2) * self.step_s
        return t, *self.at(t)

    def sets(self):
        """Times, and polynomials of slant range by ground range: changing by metres from one to the next."""
        n = self.polynomials
        reach = self.rows * self.line_s / 2
        times = np.linspace(-reach, reach, n) if n > 1 else np.zeros(1)
        rows = [[self.near_m + 9.0 * k, 0.55 + 1e-4 * k, 3.5e-7, -1e-13] for k in range(n)]
        return np.round(times, 6), np.array(rows)

    def slant(self, ground, t):
        """Slant ranges of ground ranges at times."""
        times, c = self.sets()
        if self.linear and len(times) > 1:
            rows = np.stack([np.interp(t, times, k) for k in c.T], axis=1)
        else:
            rows = c[np.abs(t[:, None] - times).argmin(axis=1)]
        return np.sum(rows * ground[:, None] ** np.arange(4), axis=1)

    def by_time(self):
        """Two-way times of the nearest and farthest pixel, their mean, and ground range by powers of time off it."""
        span = (self.columns - 1) * self.spacing_m
        near, far = 2 * self.near_m / C, 2 * (self.near_m + 0.55 * span) / C
        w = (far - near) / 2
        bent = np.polynomial.Polynomial([0.0, 1.0, -0.03 / w, 1e-3 / w**2])
        g = (bent - bent(-w)) * (span / (bent(w) - bent(-w)))
        return near, far, (near + far) / 2, g.coef

    def project(self, geographic):
        """Times [s] and slant ranges [m] of points on the orbit, and image points (x, y) [px]."""
        X = geocentric_from_geographic(geographic, WGS84)
        low, high = np.full(len(X), -20.0), np.full(len(X), 20.0)
        for _ in range(80):
            middle = (low + high) / 2
            P, V = self.at(middle)
            ahead = np.sum((X - P) * V, axis=1) > 0
            low, high = np.where(ahead, middle, low), np.where(ahead, high, middle)
        t = (low + high) / 2
        R = np.linalg.norm(X - self.at(t)[0], axis=1)
        image_t, image_R = t + self.shift_s, R + C / 2 * self.delay_s
        if self.timed:
            _, _, mean, g = self.by_time()
            column = np.polynomial.Polynomial(g)(2 * image_R / C - mean) / self.spacing_m
        elif self.ground:
            a, b = np.full(len(X), -1e5), np.full(len(X), 1e5)
            for _ in range(90):
                m = (a + b) / 2
                short = self.slant(m, image_t) < image_R
                a, b = np.where(short, m, a), np.where(short, b, m)
            column = (a + b) / 2 / self.spacing_m
        else:
            column = (image_R - self.near_m) / self.spacing_m
        column = column if self.near_first else self.columns - 1 - column
        line = (image_t - self.first_s) / self.line_s * (1 if self.forwards else -1)
        return t, R, np.column_stack([column, line]) + 0.5

    def truth(self, n=200, seed=1):
        """Geographic points in the image, and what `project` has for them."""
        rng = np.random.default_rng(seed)
        geographic = TARGET + rng.uniform([-0.02, -0.02, -300], [0.02, 0.02, 600], (4 * n, 3))
        t, R, xy = self.project(geographic)
        kept = np.flatnonzero(((xy > 0.5) & (xy < [self.columns, self.rows])).all(axis=1))[:n]
        return geographic[kept], t[kept], R[kept], xy[kept]


def tag(name, value, attributes=""):
    return f"<{name}{' ' + attributes if attributes else ''}>{value}</{name}>"


def _vectors(p):
    names = [f"{a}{k}" for k in ("Position", "Velocity") for a in "xyz"]
    units = ["m"] * 3 + ["m/s"] * 3
    return "".join(
        tag("stateVector", tag("timeStamp", p.utc(t)) + "".join(
            tag(n, repr(float(v)), f'units="{u}"') for n, u, v in zip(names, units, [*P, *V], strict=True)))
        for t, P, V in zip(*p.table(), strict=True)
    )  # fmt: skip


def _ties(p, n=60):
    geographic, _, _, xy = p.truth(n, 5)
    return "".join(
        tag("imageTiePoint", tag("imageCoordinate", tag("line", repr(y)) + tag("pixel", repr(x)))
            + tag("geodeticCoordinate", tag("latitude", repr(lat), 'units="deg"') + tag("longitude", repr(lon))
                  + tag("height", repr(h), 'units="m"')))
        for (lon, lat, h), (x, y) in zip(geographic.tolist(), (xy - 0.5).tolist(), strict=True)
    )  # fmt: skip


def functions(rpc):
    """The element rationalFunctions; its image points count from 0 at centres."""
    parts = [("pixel", rpc.image_offset[0] - 0.5, rpc.image_scale[0]), ("line", rpc.image_offset[1] - 0.5,
             rpc.image_scale[1])]  # fmt: skip
    parts += zip(("longitude", "latitude", "height"), rpc.ground_offset, rpc.ground_scale, strict=True)
    names = [f"{a}{b}Coefficients" for a in ("line", "pixel") for b in ("Numerator", "Denominator")]
    text = "".join(tag(f"{n}Offset", repr(float(o))) + tag(f"{n}Scale", repr(float(s))) for n, o, s in parts)
    rows = zip(names, rpc.coefficients.tolist(), strict=True)
    return tag("rationalFunctions", text + "".join(tag(n, " ".join(map(repr, c))) for n, c in rows))


def _common(p):
    word = {True: "Increasing", False: "Decreasing"}
    source = tag("radarParameters", tag("beams", "W1") + tag("polarizations", "HH HV")
                 + tag("antennaPointing", "Right" if p.side > 0 else "Left"))  # fmt: skip
    source += tag("orbitAndAttitude", tag("orbitInformation", tag("passDirection", "Descending") + _vectors(p)))
    last = p.first_s + (p.rows - 1) * p.line_s * (1 if p.forwards else -1)
    processing = tag("zeroDopplerTimeFirstLine", p.utc(p.first_s)) + tag("zeroDopplerTimeLastLine", p.utc(last))
    for pole in ("HH", "HV"):
        processing += tag("numberOfLinesProcessed", p.rows, f'pole="{pole}"')
    raster = tag("sampledPixelSpacing", p.spacing_m, 'units="m"') + tag("sampledLineSpacing", 3.3, 'units="m"')
    raster += tag("lineTimeOrdering", word[p.forwards]) + tag("pixelTimeOrdering", word[p.near_first])
    tables = ""
    if p.ground:
        order = range(p.polynomials)[:: 1 if p.forwards else -1]
        times, rows = p.sets()
        for k in order:
            t, c, origin = times[k], rows[k], 100.0 * k
            # powers of the distance from an origin: the same polynomial, which NumPy moves
            moved = np.polynomial.Polynomial(c)(np.polynomial.Polynomial([origin, 1.0])).coef
            tables += tag("slantRangeToGroundRange", tag("zeroDopplerAzimuthTime", p.utc(t))
                          + tag("groundRangeOrigin", origin, 'units="m"')
                          + tag("groundToSlantRangeCoefficients", " ".join(repr(float(v)) for v in moved)))  # fmt: skip
    return source, processing, raster, tables


def radarsat2(p, rpc=None, *, ties=True):
    source, processing, raster, tables = _common(p)
    kind = "SGF" if p.ground else "SLC"
    near = "" if p.ground else tag("slantRangeNearEdge", p.near_m, 'units="m"')
    geographic = tag("referenceEllipsoidParameters", tag("ellipsoidName", "WGS84") + tag("geodeticTerrainHeight", 310))
    geographic += tag("geolocationGrid", _ties(p)) if ties else ""
    geographic += functions(rpc) if rpc else ""
    raster += tag("numberOfSamplesPerLine", p.columns) + tag("numberOfLines", p.rows)
    return '<?xml version="1.0"?>' + tag(
        "product",
        tag("productId", "made up") + tag("sourceAttributes", tag("satellite", "RADARSAT-2") + source)
        + tag("imageGenerationParameters", tag("generalProcessingInformation", tag("productType", kind))
              + tag("sarProcessingInformation", processing + near) + tables)
        + tag("imageAttributes", tag("rasterAttributes", raster) + tag("geographicInformation", geographic)),
        'xmlns="http://www.rsi.ca/rs2/prod/xml/schemas"',
    )  # fmt: skip


def rcm(p, rpc=None, *, ties=True, images=1, prefix=""):
    source, processing, raster, tables = _common(p)
    far = float(p.slant(np.array([(p.columns - 1) * p.spacing_m]), np.zeros(1))[0]) if p.ground else (
        p.near_m + (p.columns - 1) * p.spacing_m)  # fmt: skip
    geographic = tag("ellipsoidParameters", tag("geodeticTerrainHeight", 310, 'units="m"'))
    geographic += tag("geolocationGrid", _ties(p)) if ties else ""
    geographic += functions(rpc) if rpc else ""
    image = tag("slantRangeFarEdge", far, 'units="m"') + tag("samplesPerLine", p.columns) + tag("numLines", p.rows)
    image += tag("slantRangeNearEdge", p.near_m, 'units="m"') + tag("lineOffset", 0) + tag("pixelOffset", 0)
    text = tag(
        "product",
        tag("productId", "made up")
        + tag("imageReferenceAttributes", tag("rasterAttributes", raster) + tag("geographicInformation", geographic))
        + tag("sceneAttributes", "".join(tag("imageAttributes", image, f'burst="{k}"') for k in range(images)))
        + tag("sourceAttributes", tag("satellite", "RCM-1") + source)
        + tag("imageGenerationParameters", tables + tag("sarProcessingInformation", processing)
              + tag("generalProcessingInformation", tag("productType", "GRD" if p.ground else "SLC"))),
        f'xmlns{":" + prefix if prefix else ""}="rcmGsProductSchema"',
    )  # fmt: skip
    if prefix:
        text = text.replace("</", "\0").replace("<", f"<{prefix}:").replace("\0", f"</{prefix}:")
    return '<?xml version="1.0" encoding="UTF-8"?>' + text


def terrasar(p):
    """The annotation; ground ranges are polynomials of time."""
    start, length = -(p.rows - 1) * p.line_s / 2, (p.rows - 1) * p.line_s
    place = ("EARLY" if p.forwards else "LATE") + "AZ" + ("NEAR" if p.near_first else "FAR") + "RG"
    if p.timed:
        near, far, mean, g = p.by_time()
        table = tag("referencePoint", repr(mean)) + tag("polynomialDegree", len(g) - 1)
        table += "".join(tag("coefficient", repr(float(v)), f'exponent="{k}"') for k, v in enumerate(g))
        specific = tag("projectedImageInfo", tag("slantToGroundRangeProjection", table))
        spacing = tag("rowSpacing", p.spacing_m, 'units="m"') + tag("columnSpacing", 3.3, 'units="m"')
    else:
        near, far = (2 * (p.near_m + k * p.spacing_m) / C for k in (0, p.columns - 1))
        specific = tag("complexImageInfo", tag("imageCoordinateType", "ZERODOPPLER"))
        spacing = tag("rowSpacing", repr(2 * p.spacing_m / C), 'units="s"')
        spacing += tag("columnSpacing", repr(p.line_s), 'units="s"')
    variant, names = "MGD" if p.timed else "SSC", [f"{k}{a}" for k in ("pos", "vel") for a in "XYZ"]
    vectors = "".join(
        tag("stateVec", tag("timeUTC", p.utc(t)[:-1]) + "".join(
            tag(n, repr(float(v))) for n, v in zip(names, [*P, *V], strict=True)), 'num="1" qualInd="1"')
        for t, P, V in zip(*p.table(), strict=True)
    )  # fmt: skip
    raster = tag("numberOfRows", p.rows) + tag("numberOfColumns", p.columns) + spacing
    times = tag("start", tag("timeUTC", p.utc(start))) + tag("stop", tag("timeUTC", p.utc(start + length)))
    times += tag("rangeTime", tag("firstPixel", repr(near)) + tag("lastPixel", repr(far)))
    return '<?xml version="1.0" encoding="utf-8"?>' + tag(
        "level1Product",
        tag("generalHeader", tag("mission", "TSX-1"))
        + tag("productInfo", tag("missionInfo", tag("mission", "TSX-1"))
              + tag("acquisitionInfo", tag("imagingMode", "SM")
                    + tag("lookDirection", "RIGHT" if p.side > 0 else "LEFT"))
              + tag("productVariantInfo", tag("productVariant", variant))
              + tag("imageDataInfo", tag("imageDataStartWith", place) + tag("imageRaster", raster))
              + tag("sceneInfo", times + tag("sceneAverageHeight", 320.0)))
        + tag("productSpecific", specific) + tag("platform", tag("orbit", vectors)),
        'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"',
    )  # fmt: skip


def georef(p):
    """Delays in two parts each."""
    parts = "".join(
        tag(name, tag("coefficient", repr(share * value), 'exponent="0"'), f'source="{source}"')
        for name, value in (("rangeDelay", p.delay_s), ("azimuthShift", p.shift_s))
        for source, share in (("IONOSPHERE", 0.25), ("TROPOSPHERE", 0.75))
    )
    return tag("geoReference", tag("signalPropagationEffects", parts))


def sicd(p, first=(0, 0)):
    """The XML of an image of range and zero Doppler; rows are ranges, columns are times; a part of it from `first`."""
    late = 5.0  # from the start of the collection to the middle of the image
    t = np.linspace(-12, 12, 60)
    axes = [np.polynomial.Polynomial.fit(t + late, v, 8).convert().coef for v in p.at(t)[0].T]

    def coefficients(values):
        return "".join(tag("Coef", repr(float(v)), f'exponent1="{k}"') for k, v in enumerate(values))

    centre, column_m = (p.columns // 2, p.rows // 3), 3.3
    step = p.line_s * (1 if p.forwards else -1)
    t_centre = late + p.first_s + centre[1] * step
    # the scene's centre lies where its pixel is: range and Doppler solved for a point of this height
    ground = centre_of(p, centre)
    X = geocentric_from_geographic(ground, WGS84)[0]
    inca = tag("TimeCAPoly", coefficients([t_centre, step / column_m]), 'order1="1"')
    inca += tag("R_CA_SCP", repr(p.near_m + centre[0] * p.spacing_m))
    return tag(
        "SICD",
        tag("CollectionInfo", tag("CollectorName", "MADE_UP")) + tag("Timeline", tag("CollectStart", p.utc(-late)))
        + tag("ImageData", tag("NumRows", p.columns - first[0]) + tag("NumCols", p.rows - first[1])
              + tag("FirstRow", first[0]) + tag("FirstCol", first[1])
              + tag("SCPPixel", tag("Row", centre[0]) + tag("Col", centre[1])))
        + tag("GeoData", tag("SCP", tag("ECF", "".join(tag(a, repr(float(v))) for a, v in zip("XYZ", X, strict=True)))))
        + tag("Grid", tag("Type", "RGZERO") + tag("Row", tag("SS", p.spacing_m)) + tag("Col", tag("SS", column_m)))
        + tag("Position", tag("ARPPoly", "".join(
            tag(a, coefficients(c), f'order1="{len(c) - 1}"') for a, c in zip("XYZ", axes, strict=True))))
        + tag("SCPCOA", tag("SideOfTrack", "R" if p.side > 0 else "L"))
        + tag("ImageFormation", tag("ImageFormAlgo", "RMA")) + tag("RMA", tag("INCA", inca)),
        'xmlns="urn:SICD:1.2.1"',
    )  # fmt: skip


def centre_of(p, column_and_line):
    """The ground point (1, 3) at 300 m of a pixel of a slant-range image, by secants over its image point."""
    place = np.array([TARGET])
    wanted = np.array(column_and_line) + 0.5
    for _ in range(12):
        at = p.project(place)[2][0]
        steps = np.array([p.project(place + d)[2][0] - at for d in np.diag([1e-5, 1e-5, 0])[:2]]) / 1e-5
        place[0, :2] += np.linalg.solve(steps.T, wanted - at)
    return place


def nitf(text):
    """A NITF with one image of 7 bytes, one text of 5, and extensions of which the second holds the XML."""
    parts = [(b"s" * 439, b"i" * 7), (b"t" * 282, b"t" * 5), (b"d" * 200, b"other"), (b"d" * 973, text.encode())]
    head = b"NITF02.10" + b" " * 30 + b"SICD: made up".ljust(315)
    counts = b"001%06d%010d" % tuple(map(len, parts[0])) + b"000" + b"000" + b"001%04d%05d" % tuple(map(len, parts[1]))
    counts += b"002" + b"".join(b"%04d%09d" % tuple(map(len, p)) for p in parts[2:]) + b"0000000000"
    return head + b"%06d" % (len(head) + 6 + len(counts)) + counts + b"".join(a + b for a, b in parts)


def iceye(p, rpc=None):
    """The XML of an SLC or a GRD; corners count from 1."""
    low = -(p.rows - 1) * p.line_s / 2
    names = ["time", *(f"{k}{a}" for k in ("pos", "vel") for a in "XYZ")]
    vectors = "".join(
        tag("orbit", tag("time", p.utc(t)) + "".join(
            tag(n, repr(float(v))) for n, v in zip(names[1:], [*P, *V], strict=True)))
        for t, P, V in zip(*p.table(), strict=True)
    )  # fmt: skip
    text = tag("product_name", "ICEYE_MADE_UP") + tag("satellite_name", "ICEYE-X0")
    text += tag("look_side", "right" if p.side > 0 else "left") + tag("avg_scene_height", 300.0)
    text += tag("number_of_range_samples", p.columns) + tag("number_of_azimuth_samples", p.rows)
    text += tag("zerodoppler_start_utc", p.utc(low)[:-1]) + tag("zerodoppler_end_utc", p.utc(-low)[:-1])
    text += tag("azimuth_time_interval", repr(p.line_s)) + tag("Orbit_State_Vectors", tag("count", p.vectors) + vectors)
    for late in (0, 1):
        for far in (0, 1):
            at = [p.columns - 1 if far == p.near_first else 0, p.rows - 1 if late == p.forwards else 0]
            lon, lat, _ = centre_of(p, at)[0].tolist()
            numbers = f"{at[0] + 1} {at[1] + 1} {lat!r} {lon!r}"
            text += tag(f"coord_{('first', 'last')[late]}_{('near', 'far')[far]}", numbers)
    if p.ground:
        _, (c,) = p.sets()
        inside = "".join(tag("coefficient", repr(float(v)), f'number="{k}"') for k, v in enumerate(c))
        text += tag("range_spacing", p.spacing_m) + tag("GRSR_Coefficients", tag("ground_range_origin", 0.0) + inside)
    else:
        text += tag("slant_range_spacing", p.spacing_m) + tag("first_pixel_time", repr(2 * p.near_m / C))
    if rpc:
        off = [*(rpc.image_offset - 0.5), *rpc.ground_offset]
        scale, keys = [*rpc.image_scale, *rpc.ground_scale], ("SAMP", "LINE", "LONG", "LAT", "HEIGHT")
        rows = zip(("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN"), rpc.coefficients.tolist(), strict=True)
        inside = "".join(tag(f"{k}_OFF", repr(float(o))) + tag(f"{k}_SCALE", repr(float(s)))
                         for k, o, s in zip(keys, off, scale, strict=True))  # fmt: skip
        text += tag("RPC", inside + "".join(tag(f"{k}_COEFF", " ".join(map(repr, c))) for k, c in rows))
    return '<?xml version="1.0"?>' + tag("Metadata", text)
