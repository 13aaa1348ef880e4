"""Every format of an RPC, written by hand from its description and read back; and the files that must be refused."""

import struct

import numpy as np
import pytest

from raybundle.errors import InputError, RaybundleError
from raybundle.io.scenes import read_scene, scene_formats
from raybundle.io.scenes.maxar import RPC00A_IN_B
from raybundle.io.scenes.rpc_text import write_rpc_text
from raybundle.scenes.rpc_image import check_image

KEYS = ("LINE", "SAMP", "LAT", "LONG", "HEIGHT")
POLYNOMIALS = ("LINE_NUM", "LINE_DEN", "SAMP_NUM", "SAMP_DEN")


def offsets(rpc):
    """Line, sample, latitude, longitude, height: offsets counted from the centre of the first pixel, and scales."""
    (x, y), (lon, lat, h) = rpc.image_offset - 0.5, rpc.ground_offset
    (sx, sy), (slon, slat, sh) = rpc.image_scale, rpc.ground_scale
    return (y, x, lat, lon, h), (sy, sx, slat, slon, sh)


def same(one, two, tolerance=1e-12):
    for name in ("coefficients", "ground_offset", "ground_scale", "image_offset", "image_scale"):
        assert np.abs(getattr(one, name) - getattr(two, name)).max() <= tolerance, name


def test_rpc_txt_loses_nothing(rpc, tmp_path):
    path = tmp_path / "a_RPC.TXT"
    write_rpc_text(rpc, path)
    scene = read_scene(path)
    assert scene.format == "rpc-text"
    same(scene.rpc, rpc)
    assert scene.rpc.err_bias_m is None


def rpb(rpc, specification="RPC00B"):
    off, scale = offsets(rpc)
    lines = ['satId = "X";', 'bandId = "P";', f'SpecId = "{specification}";', "BEGIN_GROUP = IMAGE"]
    lines += ["\terrBias = 3.5;", "\terrRand = 0.25;"]
    lines += [f"\t{k.lower()}Offset = {v!r};" for k, v in zip(KEYS, map(float, off), strict=True)]
    lines += [f"\t{k.lower()}Scale = {v!r};" for k, v in zip(KEYS, map(float, scale), strict=True)]
    for name, row in zip(("lineNumCoef", "lineDenCoef", "sampNumCoef", "sampDenCoef"), rpc.coefficients, strict=True):
        lines.append(f"\t{name} = (\n\t\t\t" + ",\n\t\t\t".join(repr(float(c)) for c in row) + ");")
    return "\n".join([*lines, "END_GROUP = IMAGE", "END;"]) + "\n"


def test_rpb(rpc, tmp_path):
    path = tmp_path / "a.RPB"
    path.write_text(rpb(rpc))
    found = read_scene(path).rpc
    same(found, rpc)
    assert (found.err_bias_m, found.err_rand_m) == (3.5, 0.25)


def test_rpc00a_is_brought_to_the_order_of_rpc00b(rpc, tmp_path):
    from dataclasses import replace

    old = replace(rpc, coefficients=rpc.coefficients[:, list(RPC00A_IN_B)])
    path = tmp_path / "a.RPB"
    path.write_text(rpb(old, "RPC00A"))
    scene = read_scene(path)
    same(scene.rpc, rpc)
    assert [r.code for r in scene.remarks] == ["rpc.terms_reordered"]


def test_order_of_rpc00a():
    from raybundle.scenes.rpc import TERMS

    old = "1 L P H LP LH PH LPH LL PP HH LLL LLP LLH LPP PPP PPH LHH PHH HHH"
    assert " ".join(TERMS[k] for k in RPC00A_IN_B) == old


def doubles(rpc):
    off, scale = offsets(rpc)
    return np.concatenate([[3.5, 0.25], off, scale, rpc.coefficients.ravel()])


def tiff(rpc, order="<", *, big=False, width=8000, height=7000, values=None):
    values = doubles(rpc) if values is None else values
    pointer, entry = ("Q", 20) if big else ("I", 12)
    head = (b"II" if order == "<" else b"MM") + (
        struct.pack(order + "HHHQ", 43, 8, 0, 16) if big else struct.pack(order + "HI", 42, 8)
    )
    count = struct.pack(order + ("Q" if big else "H"), 3)
    end = len(head) + len(count) + 3 * entry + (8 if big else 4)
    short = struct.pack(order + "H", 0)

    def tag(number, kind, n, payload):
        return struct.pack(order + "HH" + pointer, number, kind, n) + payload.ljust(8 if big else 4, b"\0")

    tags = tag(256, 3, 1, struct.pack(order + "H", width) + short)
    tags += tag(257, 4, 1, struct.pack(order + "I", height))
    tags += tag(50844, 12, len(values), struct.pack(order + pointer, end))
    return head + count + tags + b"\0" * (8 if big else 4) + struct.pack(f"{order}{len(values)}d", *values)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("big", [False, True])
def test_geotiff_tag(rpc, tmp_path, order, big):
    path = tmp_path / "a.tif"
    path.write_bytes(tiff(rpc, order, big=big))
    scene = read_scene(path)
    same(scene.rpc, rpc, 1e-11)
    assert (scene.width_px, scene.height_px) == (8000, 7000)
    assert scene.rpc.err_bias_m == 3.5


def nitf(rpc, name="RPC00B", success="1"):
    off, scale = offsets(rpc)
    y, x, lat, lon, h = off
    sy, sx, slat, slon, sh = scale
    text = f"{success}{3.5:07.2f}{0.25:07.2f}{round(y):06d}{round(x):05d}{lat:+08.4f}{lon:+09.4f}{round(h):+05d}"
    text += f"{round(sy):06d}{round(sx):05d}{slat:+08.4f}{slon:+09.4f}{round(sh):+05d}"
    for c in rpc.coefficients.ravel():
        mantissa, exponent = f"{c:+.6E}".split("E")
        text += f"{mantissa}E{'-' if int(exponent) < 0 else '+'}{min(abs(int(exponent)), 9)}"
    assert len(text) == 1041
    subheader = b"IM" + b" " * 331 + b"0000700000008000" + b" " * 90 + f"{name}01041{text}".encode()
    head = b"NITF02.10" + b" " * 345 + b"000388" + b"001" + f"{len(subheader):06d}".encode() + b"0000000010"
    return head.ljust(388) + subheader + b"\0" * 10


def test_nitf_extension(rpc, tmp_path):
    path = tmp_path / "a.ntf"
    path.write_bytes(nitf(rpc))
    scene = read_scene(path)
    # the format rounds offsets to pixels and 1e-4 degrees, and coefficients to seven digits and 1e-9
    assert np.abs(scene.rpc.coefficients - rpc.coefficients).max() < 2e-6
    assert np.abs(scene.rpc.ground_offset - rpc.ground_offset).max() < 0.5
    assert scene.rpc.image_offset == pytest.approx(np.round(rpc.image_offset - 0.5) + 0.5)
    assert (scene.width_px, scene.height_px) == (8000, 7000)


def dimap(rpc, first=1.0):
    (y, x, *ground), scale = offsets(rpc)
    off = (y + first, x + first, *ground)
    model = "".join(
        f"<{p}_COEFF_{k}>{float(c)!r}</{p}_COEFF_{k}>"
        for p, row in zip(POLYNOMIALS, rpc.coefficients, strict=True)
        for k, c in enumerate(row, 1)
    )
    pairs = [(f"{k}_OFF", v) for k, v in zip(KEYS, off, strict=True)]
    pairs += [(f"{k}_SCALE", v) for k, v in zip(KEYS, scale, strict=True)]
    domain = {"FIRST_ROW": first, "FIRST_COL": first, "LAST_ROW": first + 6999, "LAST_COL": first + 7999}
    return (
        '<?xml version="1.0"?><Dimap_Document><Metadata_Identification><METADATA_FORMAT version="2.0">DIMAP'
        "</METADATA_FORMAT></Metadata_Identification><Rational_Function_Model><Global_RFM>"
        f"<Inverse_Model>{model}</Inverse_Model><RFM_Validity><Direct_Model_Validity_Domain>"
        + "".join(f"<{k}>{v}</{k}>" for k, v in domain.items())
        + "</Direct_Model_Validity_Domain>"
        + "".join(f"<{k}>{float(v)!r}</{k}>" for k, v in pairs)
        + "</RFM_Validity></Global_RFM></Rational_Function_Model></Dimap_Document>"
    )


@pytest.mark.parametrize("first", [0.0, 1.0])
def test_dimap_counts_from_what_it_says(rpc, tmp_path, first):
    path = tmp_path / "RPC_a.XML"
    path.write_text(dimap(rpc, first))
    scene = read_scene(path)
    same(scene.rpc, rpc, 1e-11)
    assert (scene.width_px, scene.height_px) == (8000, 7000)


def written(rpc, tmp_path):
    path = tmp_path / "a_RPC.TXT"
    write_rpc_text(rpc, path)
    return path, path.read_text()


TEXT = {
    "a key missing": (lambda t: t.replace("LAT_OFF", "LAT_OF"), r"LAT_OFF.*rpc\.keys_missing"),
    "a coefficient missing": (
        lambda t: t.replace("LINE_DEN_COEFF_20:", "#"),
        r"LINEDENCOEF.*19.*20.*rpc\.coefficient_count",
    ),
    "a word for a number": (
        lambda t: t.replace("LINE_OFF: ", "LINE_OFF: x"),
        r"1.*LINE_OFF.*value\.not_a_number",
    ),
    "feet for metres": (lambda t: t.replace("meters", "feet"), r"'feet'.*rpc\.unit"),
    "radians": (lambda t: t.replace("degrees", "rad"), r"'rad'.*degrees.*rpc\.unit"),
    "a scale of zero": (lambda t: t.replace("HEIGHT_SCALE: 500.0", "HEIGHT_SCALE: 0"), r"rpc\.not_positive"),
    "a pole in the scene": (
        lambda t: "\n".join("LINE_DEN_COEFF_3: 3" if r.startswith("LINE_DEN_COEFF_3:") else r for r in t.split("\n")),
        r"rpc\.small_denominator",
    ),
    "infinite": (lambda t: t.replace("LAT_SCALE: ", "LAT_SCALE: 1e999 "), "LAT_SCALE"),
    "a key twice": (lambda t: f"{t}\nLINE_OFF: 1\n", r"LINE_OFF.*1.*line 1.*rpc\.two_values"),
    "a key twice, spelt otherwise": (lambda t: f"{t}\nline_off = 1\n", r"line_off.*1.*line 1.*rpc\.two_values"),
    "a coefficient twice": (lambda t: f"{t}\nSAMP_NUM_COEFF_3: 7\n", r"SAMP_NUM_COEFF_3.*7.*rpc\.two_values"),
    "a list beside coefficients": (lambda t: f"{t}\nlineNumCoef = (7, 8);\n", r"rpc\.two_values"),
}


@pytest.mark.parametrize("what", TEXT)
def test_bad_text_names_the_place(rpc, tmp_path, what):
    path, text = written(rpc, tmp_path)
    change, message = TEXT[what]
    changed = change(text)
    assert changed != text
    path.write_text(changed)
    with pytest.raises(InputError, match=message) as caught:
        read_scene(path)
    assert caught.value.file == str(path)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<!DOCTYPE x [<!ENTITY a "b">]><Dimap_Document/>', "DOCTYPE"),
        ('<!DOCTYPE x SYSTEM "file:///etc/passwd"><isd/>', "DOCTYPE"),
        ("<isd><IMD>", r"xml\.invalid"),
        ("<isd><IMD></IMD></isd>", r"xml\.element_missing"),
        ("<Dimap_Document></Dimap_Document>", r"dimap\.no_model"),
        ("<isd>&a;</isd>", r"xml\.invalid"),
    ],
)
def test_bad_xml_is_refused(tmp_path, text, message):
    path = tmp_path / "a.xml"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_scene(path)


def test_truncated_xml_of_a_vendor(sensors, tmp_path):
    text = (sensors / "maxar/dg_example1.xml").read_text()
    path = tmp_path / "a.xml"
    path.write_text(text[: len(text) // 2])
    with pytest.raises(InputError, match=r"XML.*xml\.invalid") as caught:
        read_scene(path)
    assert caught.value.line > 100


ISD = {
    "an entry missing": (
        lambda t: t.replace(t[t.index("<EPHEMLIST>") : t.index("</EPHEMLIST>") + 12], "", 1),
        r"EPHEMLIST.*839.*840.*maxar\.entry_count",
    ),
    "a gap": (lambda t: t.replace("<ATTLIST>4.0", "<ATTLIST>5.0", 1), r"maxar\.gap"),
    "kilometres": (lambda t: t.replace("e+06 ", "e+03 "), r"scene\.not_an_orbit"),
    "another start": (
        lambda t: t.replace("<TLCTIME>1959-11-25T17:39:48", "<TLCTIME>1959-11-25T18:39:48"),
        r"trajectory\.not_covered",
    ),
    "no time": (lambda t: t.replace("<TLCTIME>1959-11-25T17", "<TLCTIME>1959-11-25 ?17"), r"value\.no_time"),
    "no rows": (lambda t: t.replace("<NUMROWS>23708", "<NUMROWS>0"), r"scene\.pixel_count"),
    "another image": (lambda t: t.replace("<NUMCOLUMNS>35170", "<NUMCOLUMNS>99170"), r"rpc\.other_image"),
}


@pytest.mark.parametrize("what", ISD)
def test_bad_isd_names_the_place(sensors, tmp_path, what):
    change, message = ISD[what]
    text = (sensors / "maxar/dg_example1.xml").read_text()
    changed = change(text)
    assert changed != text
    path = tmp_path / "a.xml"
    path.write_text(changed)
    with pytest.raises(InputError, match=message) as caught:
        read_scene(path)
    assert caught.value.file == str(path)


def test_isd_without_rpc_and_without_orbit(sensors, tmp_path):
    scene = read_scene(sensors / "maxar/dg_example2.xml")
    assert scene.rpc is None
    assert scene.rigorous is not None
    text = (sensors / "maxar/dg_example1.xml").read_text()
    path = tmp_path / "a.xml"
    path.write_text(text.replace("<EPH>", "<EPX>").replace("</EPH>", "</EPX>"))
    scene = read_scene(path)
    assert scene.rigorous is None
    assert "maxar.no_rigorous_model" in [r.code for r in scene.remarks]


def test_image_and_rpc_that_do_not_belong_together(rpc):
    check_image(rpc, 8000, 7000, "a")
    check_image(rpc, 4100, 3600, "a")  # a part
    for size in ((20000, 7000), (8000, 30000)):
        with pytest.raises(InputError, match=r"rpc\.other_image") as raised:
            check_image(rpc, *size, "a")
        assert (raised.value.message.values["width_px"], raised.value.message.values["height_px"]) == size
    with pytest.raises(InputError, match=r"rpc\.other_image"):
        check_image(rpc.shifted(np.array([20000.0, 0.0])), 4000, 4000, "a")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (lambda r: tiff(r)[:60], r"tiff\.ends_early"),
        (lambda r: tiff(r, values=doubles(r)[:40]), r"40.*92.*rpc\.tag_count"),
        (lambda r: tiff(r, values=np.full(92, np.nan)), r"rpc\.not_finite"),
        (lambda r: tiff(r).replace(struct.pack("<H", 50844), struct.pack("<H", 50845)), r"rpc\.no_tag"),
        (lambda _: b"II*\0" + b"\xff" * 30, r"tiff\.ends_early"),
        (lambda r: nitf(r, success="0"), r"nitf\.rpc_invalid"),
        (lambda r: nitf(r)[:-400], r"nitf\.rpc_invalid"),
        (lambda r: nitf(r, name="RPC00X"), r"RPC00B.*nitf\.no_rpc"),
        (lambda r: nitf(r).replace(b"000388001", b"000388000"), r"nitf\.no_image"),
        (lambda r: nitf(r).replace(b"0003.50", b"000x.50"), r"value\.not_finite"),
        (lambda _: b"NITF02.10" + b" " * 400, r"HL.*nitf\.field"),
    ],
)
def test_bad_images(rpc, tmp_path, data, message):
    path = tmp_path / "a.img"
    path.write_bytes(data(rpc))
    with pytest.raises(InputError, match=message):
        read_scene(path)


def test_unknown_and_absent_files(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("once upon a time")
    with pytest.raises(InputError, match=r"Maxar.*scene\.format_unknown"):
        read_scene(path)
    with pytest.raises(InputError, match=r"file\.missing"):
        read_scene(tmp_path / "b")
    for nothing in (b"", b" \n\n"):
        path.write_bytes(nothing)
        with pytest.raises(InputError, match=r"a\.txt.*file\.empty"):
            read_scene(path)
    assert set(scene_formats) == {
        "airborne",
        "maxar",
        "dimap",
        "spot",
        "csm",
        "rpc-text",
        "geotiff",
        "nitf",
        "enmap",
        "sentinel1",
        "radarsat2",
        "rcm",
        "terrasar",
        "sicd",
        "iceye",
        "envisat",
        "ceos",
        "rpc-json",
        "gdal-xml",
        "gdal-json",
        "orthority",
        "optical_bar",
        "iceye-hdf5",
        "cosmo",
        "capella",
        "radarsat1",
        "nisar",
    }


@pytest.mark.parametrize("seed", range(40))
def test_damaged_bytes_give_errors_or_a_scene(rpc, tmp_path, seed):
    rng = np.random.default_rng(seed)
    kinds = (tiff(rpc), nitf(rpc), rpb(rpc).encode(), dimap(rpc).encode())
    data = np.frombuffer(kinds[seed % 4], np.uint8).copy()
    where = rng.integers(4, len(data), 8)
    data[where] = rng.integers(0, 256, 8)
    if seed % 3 == 0:
        data = data[: int(rng.integers(10, len(data)))]
    path = tmp_path / "a.bin"
    path.write_bytes(data.tobytes())
    said = str(path)
    try:
        found = read_scene(path).rpc
    except RaybundleError as error:
        found, said = None, str(error)
    assert str(path) in said
    assert found is None or np.isfinite(found.coefficients).all()
