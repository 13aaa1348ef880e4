"""The elements of a Metashape chunk: sensors, cameras, rigs, components and markers.

A camera's transform turns and shifts its axes (x right, y down, z forward) to those of the chunk, or of the component
that holds it; the transform of the component, or of the chunk before version 2, leads from there to object space.  A
slave of a rig has the transform of its master times rotation and location of its sensor.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TypeVar

import numpy as np

from raybundle.block import Camera, Images, Role
from raybundle.cameras.conversions import camera_from_forward
from raybundle.cameras.equirectangular import equirectangular_camera
from raybundle.cameras.forward_camera import ForwardCamera
from raybundle.errors import InputError, Message, note
from raybundle.io.formats.base import SENSOR_FROM_CV, Tracks, fitted_camera
from raybundle.io.geo.coordinate_systems import local_frame
from raybundle.io.reading.ledger import enter
from raybundle.io.reading.words import number_of, numbers_of, quoted
from raybundle.io.reading.xml import Element
from raybundle.numerics.arrays import Array, Index
from raybundle.numerics.rotation import nearest_rotation

NO_GEOMETRY = (
    "version", "label", "name", "enabled", "next_id", "next_group_id", "active_id", "id", "value", "locked",
    "orientation", "region", "settings", "meta", "bands", "data_type", "covariance", "rotation_covariance",
    "location_covariance", "params", "black_level", "sensitivity", "vignetting", "layer_index", "partition", "class",
    "pinned", "valid",
    "type of <calibration>",
)  # fmt: skip
"""Elements and attributes without bearing on the block."""
_UNIT = re.compile(r'UNIT\s*\[\s*"([^"]*)"\s*,\s*([-+.\deE]+)')
"""Name and length [m] of the unit in the WKT of a local system."""
DEFAULT_SIGMA = 0.005
"""Standard deviation of markers in Metashape where the chunk sets none [m]."""
T = TypeVar("T")


@dataclass(slots=True)
class Reading:
    """What a reader remarks on while it goes through a file."""

    path: Path
    remarks: list[Message] = field(default_factory=list[Message])
    deviations: list[float] = field(default_factory=list[float])
    errors: dict[str, list[InputError]] = field(default_factory=dict[str, list[InputError]])
    """Elements that could not be read, by kind."""

    def attempt(self, kind: str, read: Callable[[], T]) -> T | None:
        """What `read` returns; an error costs this element alone."""
        try:
            return read()
        except InputError as error:
            self.errors.setdefault(kind, []).append(error)
            return None

    def all_remarks(self) -> tuple[Message, ...]:
        """The remarks, and one for each kind of elements with errors."""
        return (*self.remarks, *(_elements_remark(kind, e) for kind, e in self.errors.items()))


def _elements_remark(kind: str, errors: Sequence[InputError]) -> Message:
    """Elements that are left out, and why the first one is."""
    first = next((replace(e.message, place=e.place) for e in errors if e.message is not None), None)
    return replace(
        note("import.elements_left_out", kind=kind.replace(" ", "_"), n=len(errors)),
        details=() if first is None else (first,),
    )


def disabled(element: Element, name: str = "enabled") -> bool:
    """Whether an element is switched off."""
    return element.attributes.get(name, "").strip().lower() in {"false", "0"}


def chunk_of(chunks: Sequence[Element], found: Reading) -> Element:
    """The first enabled chunk with cameras, else the first with cameras, else the first."""
    full = [c for c in chunks if (group := c.find("cameras")) is not None and len(_cameras(group))]
    chunk = next((c for c in full if not disabled(c)), (full or chunks)[0])
    for other in chunks:
        if other is not chunk:
            other.leave_out()
    if len(chunks) > 1:
        number = 1 + chunks.index(chunk)
        found.remarks.append(note("import.one_chunk", number=number, n=len(chunks)))
    if disabled(chunk):
        found.remarks.append(note("import.chunk_disabled"))
    return chunk


def _enabled(elements: list[Element], kind: str, found: Reading) -> list[Element]:
    """Those that are not switched off, and a remark on the others."""
    off = [e for e in elements if disabled(e)]
    for element in off:
        element.leave_out()
    if off:
        found.remarks.append(note("import.elements_disabled", kind=kind.replace(" ", "_"), n=len(off)))
    return [e for e in elements if not disabled(e)]


def _cameras(group: Element) -> list[Element]:
    return [*group.all("camera"), *(c for g in group.all("group") for c in g.all("camera"))]


def read_sensors(chunk: Element, found: Reading) -> dict[str, Camera]:
    """Cameras by the ids of their sensors; raises InputError where there is none."""
    cameras: dict[str, Camera] = {}
    sensors = list(chunk.get("sensors").all("sensor"))
    for sensor in sensors:
        camera = found.attempt("sensor", lambda sensor=sensor: _sensor(sensor, found))
        if camera is not None:
            cameras[sensor.attribute("id")] = camera
    if not cameras:
        if found.errors:
            raise next(iter(found.errors.values()))[0]
        chunk.get("sensors").fail("metashape.no_calibration")
    return cameras


def _sensor(sensor: Element, found: Reading) -> Camera | None:
    given = list(sensor.all("calibration"))
    calibration = next((c for c in given if c.attributes.get("class") == "adjusted"), given[0] if given else None)
    kind = sensor.attributes.get("type", "frame")
    if calibration is not None:
        kind = calibration.attributes.get("type", kind)
    id_ = sensor.attribute("id")
    if kind == "spherical":
        resolution = sensor.find("resolution") or (calibration or sensor).get("resolution")
        return equirectangular_camera(id_, _size(resolution, "width"), _size(resolution, "height"), whole_sphere=False)
    place = calibration or sensor
    if kind not in {"frame", "fisheye"}:
        place.fail("value.not_supported", value=quoted(kind), known=["frame", "fisheye", "spherical"])
    if calibration is None:
        label = sensor.attributes.get("label", "?")
        found.remarks.append(note("import.sensor_without_calibration", sensor=label))
        return None
    forward = _forward(sensor, calibration, kind)
    fit = camera_from_forward(forward, id_, pixel_mm=_pixel(sensor), where=f"{found.path}: ")
    return fitted_camera(fit, id_, found.remarks, found.deviations)


def _forward(sensor: Element, calibration: Element, kind: str) -> ForwardCamera:
    for term in ("p3", "p4"):
        if calibration.number(term, 0.0):
            calibration.fail("metashape.p3_p4", parameter=term)
    given = [r for r in (calibration.find("resolution"), sensor.find("resolution")) if r is not None]
    sizes = [(_size(r, "width"), _size(r, "height")) for r in given or [sensor.get("resolution")]]
    width, height = sizes[0]
    if sizes[-1] != sizes[0]:
        calibration.fail(
            "metashape.sizes_differ",
            width_px=width,
            height_px=height,
            sensor_width_px=sizes[-1][0],
            sensor_height_px=sizes[-1][1],
        )
    f, b1 = calibration.number("f"), calibration.number("b1", 0.0)
    if f <= 0 or f + b1 <= 0:
        calibration.fail("focal_length.not_positive", lengths=[f, f + b1])
    return ForwardCamera(
        width_px=width,
        height_px=height,
        projection="equidistant" if kind == "fisheye" else "central",
        fx=f + b1,
        fy=f,
        cx=width / 2 + calibration.number("cx", 0.0),
        cy=height / 2 + calibration.number("cy", 0.0),
        skew=calibration.number("b2", 0.0),
        **{t: calibration.number(t, 0.0) for t in ("k1", "k2", "k3", "k4")},
        p1=calibration.number("p2", 0.0),
        p2=calibration.number("p1", 0.0),
    )


def _pixel(sensor: Element) -> float | None:
    for p in sensor.all("property"):
        if p.attributes.get("name") == "pixel_height":
            size = p.value("value")
            return size if 0 < size < 1 else None
    return None


def _size(element: Element, name: str) -> int:
    value = element.value(name)
    if value != int(value) or not 0 < value <= 10_000_000:
        element.fail("value.not_whole", value=f"{value:g}", least=1, most=10_000_000)
    return int(value)


@dataclass(frozen=True, slots=True)
class _Similarity:
    """From the axes of a chunk or component to object space."""

    scale: float = 1.0
    rotation: Array = field(default_factory=lambda: np.eye(3))
    translation: Array = field(default_factory=lambda: np.zeros(3))

    def pose(self, M: Array) -> tuple[Array, Array]:
        """Projection centre and rotation from object axes to our sensor axes of a transform (4, 4)."""
        centre = self.scale * self.rotation @ M[:3, 3] + self.translation
        return centre, SENSOR_FROM_CV @ nearest_rotation(M[:3, :3]).T @ self.rotation.T


def _similarity(element: Element | None) -> _Similarity | None:
    if element is None:
        return None
    R = element.get("rotation").numbers(9).reshape(3, 3) if element.find("rotation") else np.eye(3)
    t = element.get("translation").numbers(3) if element.find("translation") else np.zeros(3)
    scale = element.number("scale", 1.0)
    if scale <= 0 or np.abs(R @ R.T - np.eye(3)).max() > 1e-4 or np.linalg.det(R) < 0:
        element.fail("metashape.no_similarity")
    return _Similarity(scale, nearest_rotation(R), t)


@dataclass(slots=True)
class _Frames:
    """The transforms of a chunk: its own, and those of its components."""

    own: _Similarity | None
    components: dict[str, _Similarity | None]
    members: dict[str, str]
    """Id of a camera -> of its component, as the components list them."""

    def component_of(self, camera: Element) -> str:
        """Id of the component that holds a camera; of the only one where nothing else names one."""
        named = camera.attributes.get("component_id", self.members.get(camera.attributes.get("id"), ""))
        if named in self.components:
            return named
        return next(iter(self.components)) if len(self.components) == 1 else ""

    def transform(self, component: str) -> _Similarity | None:
        """To object space: of the component, else of the chunk."""
        return self.components.get(component) or self.own


def _frames(chunk: Element) -> _Frames:
    components: dict[str, _Similarity | None] = {}
    members: dict[str, str] = {}
    group = chunk.find("components")
    for component in group.all("component") if group else ():
        id_ = component.attribute("id")
        components[id_] = _similarity(component.find("transform"))
        listed = component.find("partition", "camera_ids")
        members |= dict.fromkeys(listed.content.split() if listed else (), id_)
    return _Frames(_similarity(chunk.find("transform")), components, members)


def _matrix(camera: Element) -> Array | None:
    """The transform (4, 4) of a camera; None: not aligned."""
    transform = camera.find("transform")
    if transform is None:
        return None
    M = transform.numbers(16).reshape(4, 4)
    if np.abs(M[:3, :3] @ M[:3, :3].T - np.eye(3)).max() > 1e-4 or np.linalg.det(M[:3, :3]) < 0:
        transform.fail("rotation.not_orthogonal")
    return M


def _mounting(sensor: Element) -> Array | None:
    """Rotation and location (4, 4) of a slave sensor on the axes of its master; None: it states neither."""
    rotation, location = sensor.find("rotation"), sensor.find("location")
    if rotation is None and location is None:
        return None
    M = np.eye(4)
    if rotation is not None:
        R = rotation.numbers(9).reshape(3, 3)
        if np.abs(R @ R.T - np.eye(3)).max() > 1e-4 or np.linalg.det(R) < 0:
            rotation.fail("rotation.not_orthogonal")
        M[:3, :3] = nearest_rotation(R)
    if location is not None:
        M[:3, 3] = location.numbers(3)
    return M


@dataclass(frozen=True, slots=True, kw_only=True)
class _Image:
    id: str
    label: str
    sensor: str
    component: str
    matrix: Array | None


def read_images(chunk: Element, cameras: Mapping[str, Camera], found: Reading) -> tuple[Images, dict[str, int], bool]:
    """The images, their positions by the ids of the cameras in the file, and whether nothing fixes the scale."""
    frames = _frames(chunk)
    rows = _rows(chunk, cameras, frames, found)
    oriented = [r for r in rows if r.matrix is not None]
    scaled = {r.component for r in oriented if frames.transform(r.component) is not None}
    used = scaled or _largest(oriented)
    free = bool(oriented) and not scaled
    if free:
        found.remarks.append(note("import.no_object_space"))
    apart = sum(r.component not in used for r in oriented)
    if apart:
        found.remarks.append(note("import.components_apart", n=apart))
    reference = chunk.find("reference")
    if not free and reference is not None and not _is_local(reference):
        found.remarks.append(note("import.geocentric"))
    order = {id_: k for k, id_ in enumerate(cameras)}
    centre, rotation = np.full((len(rows), 3), np.nan), np.full((len(rows), 3, 3), np.nan)
    for k, row in enumerate(rows):
        if row.matrix is not None and row.component in used:
            centre[k], rotation[k] = (frames.transform(row.component) or _Similarity()).pose(row.matrix)
    labels = tuple(r.label for r in rows)
    images = Images(
        ids=labels,
        camera=np.array([order[r.sensor] for r in rows], np.int32),
        file=labels,
        centre=centre,
        rotation=rotation,
    )
    return images, {r.id: k for k, r in enumerate(rows)}, free


def _largest(rows: list[_Image]) -> set[str]:
    """The component with the most images."""
    names = [r.component for r in rows]
    return {max(names, key=names.count)} if names else set()


def _is_local(reference: Element) -> bool:
    return reference.content.strip().startswith("LOCAL_CS")


def _rows(chunk: Element, cameras: Mapping[str, Camera], frames: _Frames, found: Reading) -> list[_Image]:
    """The images of calibrated sensors; a camera with an error is left out."""
    group = chunk.get("cameras")
    elements = _cameras(group)
    sensors = {s.attributes.get("id"): s for s in chunk.get("sensors").all("sensor")}
    matrices = {c.attributes.get("id"): found.attempt("transform", lambda c=c: _matrix(c)) for c in elements}
    mounted = {
        id_: found.attempt("rotation or location of a sensor", lambda s=s: _mounting(s))
        for id_, s in sensors.items()
        if s.attributes.get("master_id")
    }
    labels: set[str] = set()

    def image(element: Element) -> _Image | None:
        sensor = element.attribute("sensor_id")
        if sensor not in cameras:
            return None
        label = _label(element, labels)
        id_, master = element.attribute("id"), element.attributes.get("master_id")
        matrix, mounting = matrices[id_], mounted.get(sensor)
        if matrix is None and master and mounting is not None:
            from_master = matrices.get(master)
            matrix = None if from_master is None else from_master @ mounting
        labels.add(label)
        whole = next((e for e in elements if e.attributes.get("id") == master), element) if master else element
        component = frames.component_of(element if "component_id" in element.attributes else whole)
        return _Image(id=id_, label=label, sensor=sensor, component=component, matrix=matrix)

    used = _enabled(elements, "disabled camera", found)
    if elements and not used:
        group.fail("metashape.cameras_disabled")
    read = (found.attempt("camera", lambda element=element: image(element)) for element in used)
    rows = [row for row in read if row is not None]
    if not rows:
        if found.errors.get("camera"):
            raise found.errors["camera"][0]
        group.fail("metashape.no_calibrated_camera")
    return rows


def _label(element: Element, taken: set[str]) -> str:
    label = element.attribute("label")
    if not label.isprintable():
        element.fail("name.unprintable", name=quoted(label))
    if not label or label != label.strip():
        element.fail("name.blanks", name=quoted(label))
    if label in taken:
        element.fail("name.twice", kind="image", name=quoted(label))
    return label


@dataclass(frozen=True, slots=True)
class Control:
    """Roles, given coordinates (p, 3) and standard deviations (p, 3) of markers."""

    role: Index
    xyz: Array
    sigma: Array


def read_markers(chunk: Element, numbers: Mapping[str, int], found: Reading) -> tuple[Tracks, Control]:
    """Markers with their image points; those with a reference are control points, disabled ones check points."""
    group = chunk.find("markers")
    taken: set[str] = set()
    kept: dict[str, Element] = {}
    markers = list(group.all("marker")) if group else []
    for marker in _enabled(markers, "disabled marker", found):
        id_ = found.attempt("marker", lambda marker=marker: (_label(marker, taken), marker.attribute("id"))[1])
        if id_ is not None:
            taken.add(marker.attribute("label"))
            kept[id_] = marker
    off = {m.attributes.get("id") for m in markers if disabled(m)}
    position = {id_: k for k, id_ in enumerate(kept)}
    image: list[int] = []
    point: list[int] = []
    xy: list[tuple[float, float]] = []
    measured = chunk.find("frames", "frame", "markers")
    for marker in measured.all("marker") if measured else ():
        k = position.get(id_ := marker.attribute("marker_id"))
        if k is None:
            enter("<marker> of <frame>", 0 if id_ in off else 1)
            continue
        for location in marker.all("location"):
            at = numbers.get(location.attribute("camera_id"))
            if at is None or disabled(location, "pinned") or disabled(location, "valid"):
                continue
            image.append(at)
            point.append(k)
            xy.append((location.value("x"), location.value("y")))
    control = _control(chunk, list(kept.values()), found)
    tracks = Tracks(
        point_ids=tuple(m.attribute("label") for m in kept.values()),
        xyz=control.xyz,
        image=np.array(image, np.int64),
        point=np.array(point, np.int64),
        xy_px=np.array(xy, float).reshape(-1, 2),
    )
    return tracks, control


def _control(chunk: Element, markers: list[Element], found: Reading) -> Control:
    count = len(markers)
    role = np.full(count, Role.TIE, np.int32)
    xyz, sigma = np.full((count, 3), np.nan), np.full((count, 3), np.nan)
    default, assumed = _marker_sigma(chunk), 0
    for k, marker in enumerate(markers):
        reference = marker.find("reference")
        if reference is None:
            continue
        read = found.attempt("reference of a marker", lambda reference=reference: _reference(reference))
        if read is None or not np.isfinite(read[0]).any():
            continue
        role[k] = Role.CHECK if disabled(reference) else Role.CONTROL
        xyz[k], sigma[k] = read
        if not np.isfinite(sigma[k]).any():
            sigma[k] = np.where(np.isfinite(xyz[k]), default, np.nan)
            assumed += 1
    if assumed:
        sigma_m = [f"{v:g}" for v in dict.fromkeys(default.tolist())]
        found.remarks.append(note("import.marker_sigma_assumed", n=assumed, sigma_m=sigma_m))
    return _in_object_space(chunk, Control(role, xyz, sigma), found)


def _reference(reference: Element) -> tuple[Array, Array]:
    """Coordinates and standard deviations (3,); NaN where they are not stated."""
    values = [reference.value(n) if n in reference.attributes else np.nan for n in "xyz"]
    sigma: list[float] = []
    for name, value in zip("xyz", values, strict=True):
        key = next((a for a in (f"s{name}", "sxy" if name != "z" else "", "sxyz") if a in reference.attributes), "")
        sigma.append(reference.value(key) if key and np.isfinite(value) else np.nan)
    if any(s < 0 for s in sigma):
        reference.fail("cell.negative_sigma", value=quoted(min(sigma)))
    return np.array(values), np.array(sigma)


def _marker_sigma(chunk: Element) -> Array:
    """(3,) standard deviation of markers that state none, by the settings of the chunk."""
    settings = chunk.find("settings")
    for p in settings.all("property") if settings else ():
        if p.attributes.get("name") == "accuracy_markers":
            values = numbers_of(p.attribute("value").replace("/", " ").split())
            if values is not None and len(values) in {1, 2, 3} and (values > 0).all():
                return np.array(
                    [values[0], values[min(1, len(values) - 1)] if len(values) == 3 else values[0], values[-1]]
                )
    return np.full(3, DEFAULT_SIGMA)


def _in_object_space(chunk: Element, control: Control, found: Reading) -> Control:
    """Coordinates of a georeferenced chunk as geocentric ones, as its cameras stand."""
    reference = chunk.find("reference")
    given = np.asarray(control.role) != Role.TIE
    if reference is None or not reference.content.strip() or not given.any():
        return control
    if _is_local(reference):
        return _in_metres(reference, control, found)
    whole = given & np.isfinite(control.xyz).all(axis=1)
    xyz, sigma, role = control.xyz.copy(), control.sigma.copy(), np.array(control.role)
    try:
        frame = local_frame(reference.content.strip(), control.xyz[whole][0]) if whole.any() else None
    except InputError as error:
        frame = None
        why = () if error.message is None else (error.message,)
        found.remarks.append(replace(note("import.system_not_read"), details=why))
    lost = given & ~whole if frame is not None else given
    xyz[lost], sigma[lost], role[lost] = np.nan, np.nan, Role.TIE
    enter("<reference> of <marker>", int(lost.sum()))
    if frame is not None:
        origin, axes = frame.geocentric
        xyz[whole] = origin + frame.local_from_crs(control.xyz[whole]) @ axes
        sigma[whole] = np.sqrt(control.sigma[whole] ** 2 @ axes**2)
    return Control(role, xyz, sigma)


def _in_metres(reference: Element, control: Control, found: Reading) -> Control:
    """Coordinates of a local system in metres, as its cameras stand; standard deviations are metres in each system."""
    unit = _UNIT.search(reference.content)
    length = 1.0 if unit is None else number_of(unit[2])
    if length is None or length <= 0:
        reference.fail("metashape.unit_length")
    if unit is None or length == 1:
        return control
    found.remarks.append(note("import.markers_converted", unit=unit[1], length_m=f"{length:g}"))
    return Control(control.role, control.xyz * length, control.sigma)
