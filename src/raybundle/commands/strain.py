"""`raybundle strain`: displacements and strains of a flat specimen from the images of one camera."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from raybundle.commands.strain_results import StrainImage, Strains, StrainSettings, state_counts
from raybundle.errors import InputError, Message, Severity, note, warning
from raybundle.numerics.progress import Progress, silent
from raybundle.settings import keywords, made

if TYPE_CHECKING:
    from raybundle.io.photos.photo import Photo
    from raybundle.matching.subsets import Followed, SubsetGrid
    from raybundle.numerics.arrays import Array, Mask

BENT_PX, BENT_SHARE = 0.02, 0.05
"""Displacement within subsets against their shape, and the share of subsets above it, from which on this is reported:
it displaces a subset by up to a quarter of itself, which is the bias that digital image correlation usually allows."""

JUMPING, REPEATED = 0.01, 0.6
"""Share of neighbours that contradict each other, and correlation of the reference with itself at another place, from
which on these are reported: random speckles reach 0.2"""
EXACT_PX = 1e-4
"""Standard deviation below which images are one picture: grey values in whole numbers alone give some 0.0005 px"""
SATURATED = 0.1
"""Share of the pixels of the specimen at an end of the grey scale from which on this is reported: with 29 % of them
displacements err by 1.2 standard deviations, with 79 % by 1.75"""
UNEVEN = 1.5
"""Distance of displacements from the plane of an area, in standard deviations, from which on this is reported: noise
alone gives 1, which overlapping subsets make smaller"""
LARGEST = 0.99
"""Quantile of the largest normal strains that is reported: single ones beside weak texture are uncertain"""


@keywords(StrainSettings)
def strain(
    reference: str | Path, deformed: str | Path | Sequence[str | Path], out: str | Path, *,
    progress: Progress = silent, **settings: Any,
) -> Strains:  # fmt: skip
    """Measure displacements and strains of a flat specimen by digital image correlation.

    reference  image before the load
    deformed   images under load, in the order of time, of the same size
    out        new folder: displacements.csv, strain.csv, maps, result.json
    settings   as of the command line, by the names of `StrainSettings`: step=10, window=31, scale=0.05
    raises     InputError for images of other sizes, and where no subset is found again
    Limits: motion towards the camera and lens distortion look like strain.
    """
    several = [deformed] if isinstance(deformed, str | Path) else [*deformed]
    given = {"reference": Path(reference), "deformed": tuple(Path(d) for d in several), "out": Path(out), **settings}
    return run_strain(made(StrainSettings, given), progress)


def run_strain(settings: StrainSettings, progress: Progress = silent) -> Strains:
    """Follow the subsets through the images, and write what came of it."""
    import numpy as np

    from raybundle.commands.strain_files import write_strains
    from raybundle.io.folders import check_new_folder
    from raybundle.io.photos.photo import read_grey, read_photo
    from raybundle.matching.spline_pictures import Picture
    from raybundle.matching.subsets import Followed, State, SubsetGrid, follow, window_options

    own = settings.reference.resolve()
    without = tuple(p for p in settings.deformed if p.resolve() != own)  # load-*.tif names the reference, too
    s = replace(settings, deformed=without or settings.deformed)
    check_new_folder(s.out)
    areas_of(s.area)
    photos = [read_photo(p) for p in (s.reference, *s.deformed)]
    _check(photos)
    _check_areas(s, photos[0])
    reference = read_grey(photos[0])
    window = window_options(s.window // 2, quadratic=s.shape == "quadratic")
    free = _free(s, photos[0])
    grid = SubsetGrid.of(free, s.step, window.half)
    if not len(grid.xy_px):
        raise InputError("strain.no_subset", window=2 * window.half + 1, file=s.reference)
    first, previous = Picture.of(reference, 1), None
    images, found = list[StrainImage](), list[Followed]()
    for k, photo in enumerate(photos[1:]):
        progress("following subsets", k / len(s.deformed))
        f = follow(first, Picture.of(read_grey(photo), 2), grid, window, previous)
        if (f.state == State.FOLLOWED).any():
            previous = f
        found.append(f)
    if previous is None:
        raise InputError("strain.nothing_followed", n=len(grid.xy_px), names=[p.name for p in photos[1:]])
    for name, f in zip(names_of(s.deformed), found, strict=True):
        images.append(_image(s, name, grid, f))
    reported = (*_of_reference(s, photos[0].name, reference, free), *_reported(s, grid, images))
    done = Strains(settings=s, grid=grid, images=tuple(images), reported=reported, files=())
    progress("writing", 0.9)
    files = write_strains(done, reference, np.array([photos[0].width_px, photos[0].height_px]))
    return Strains(settings=s, grid=grid, images=done.images, reported=done.reported, files=files)


def _check(photos: Sequence[Photo]) -> None:
    """Raise InputError for images that cannot be compared."""
    first = photos[0]
    for photo in photos[1:]:
        if (photo.width_px, photo.height_px) != (first.width_px, first.height_px):
            raise InputError(
                "strain.other_size", width_px=photo.width_px, height_px=photo.height_px, reference=first.name,
                reference_width_px=first.width_px, reference_height_px=first.height_px, file=photo.path,
            )  # fmt: skip
        if photo.sha256 == first.sha256:
            raise InputError("strain.same_image", reference=first.name, file=photo.path)


def _free(s: StrainSettings, photo: Photo) -> Mask:
    """(h, w) pixels of the specimen."""
    import numpy as np

    from raybundle.io.photos.photo import read_grey, read_photo

    free = np.ones((photo.height_px, photo.width_px), bool)
    if s.extent is not None:
        left, top, right, bottom = s.extent
        if not (left < right and top < bottom):
            raise InputError("strain.empty_extent", extent=[float(v) for v in s.extent])
        y, x = np.ogrid[: photo.height_px, : photo.width_px]
        free &= (x >= left) & (x + 1 <= right) & (y >= top) & (y + 1 <= bottom)
    if s.mask is not None:
        mask = read_photo(s.mask)
        if (mask.width_px, mask.height_px) != (photo.width_px, photo.height_px):
            raise InputError(
                "strain.other_size", width_px=mask.width_px, height_px=mask.height_px, reference=photo.name,
                reference_width_px=photo.width_px, reference_height_px=photo.height_px, file=s.mask,
            )  # fmt: skip
        free &= read_grey(mask) > 0
    return free


def _image(s: StrainSettings, name: str, grid: SubsetGrid, f: Followed) -> StrainImage:
    import numpy as np

    from raybundle.matching.subset_noise import overlap_correlation
    from raybundle.matching.subsets import State, window_options
    from raybundle.metrology.strain import area_strain, rigid_motion, strain_field

    d = f.xy_px - grid.xy_px
    good = f.state == State.FOLLOWED
    window = window_options(s.window // 2, quadratic=s.shape == "quadratic")
    gauge = s.gauge // 2
    rho = overlap_correlation(window, s.step, max(2 * gauge, -(-s.window // s.step)))
    middle = len(rho) // 2
    near = rho[middle - 2 * gauge : middle + 2 * gauge + 1, middle - 2 * gauge : middle + 2 * gauge + 1]
    rigid = rigid_motion(grid.xy_px[good], d[good], f.cov_px2[good], float(rho.sum()))
    return StrainImage(
        name=name, followed=f, displacement=d, rigid=rigid,
        relative=np.where(good[:, None], d - rigid.displacement(grid.xy_px), np.nan),
        strain=strain_field(d, f.cov_px2, grid.cell, grid.shape, float(s.step), gauge, near),
        areas={
            name: area_strain(d, f.cov_px2, grid.cell, grid.shape, float(s.step), _inside(grid, corners), rho)
            for name, corners in areas_of(s.area).items()
        },
    )  # fmt: skip


def areas_of(given: Sequence[str]) -> dict[str, tuple[float, float, float, float]]:
    """Rectangles by their names; raises InputError for a text that is none."""
    from raybundle.io.reading.words import number_of

    found: dict[str, tuple[float, float, float, float]] = {}
    for text in given:
        name, _, corners = text.partition(":")
        values = [number_of(v) for v in corners.split(",")]
        left, top, right, bottom = values if len(values) == 4 else [None] * 4
        if not name or left is None or top is None or right is None or bottom is None or name in found:
            raise InputError("strain.area_text", text=text)
        if not (left < right and top < bottom):
            raise InputError("strain.empty_extent", extent=[left, top, right, bottom])
        found[name] = (left, top, right, bottom)
    return found


def _check_areas(s: StrainSettings, photo: Photo) -> None:
    """Raise InputError for an area that is not within the image."""
    for name, (left, top, right, bottom) in areas_of(s.area).items():
        if left < 0 or top < 0 or right > photo.width_px or bottom > photo.height_px:
            raise InputError("strain.area_outside", area=name, width_px=photo.width_px, height_px=photo.height_px)


def _inside(grid: SubsetGrid, corners: tuple[float, float, float, float]) -> Mask:
    """(n,) subsets with their middle in a rectangle."""
    (x, y), (left, top, right, bottom) = grid.xy_px.T, corners
    return (x >= left) & (x <= right) & (y >= top) & (y <= bottom)


def names_of(paths: Sequence[Path]) -> list[str]:
    """Names of files, with as many of their folders as make them different; raises InputError for one given twice."""
    resolved = [p.resolve() for p in paths]
    twice = next((p for k, p in enumerate(resolved) if p in resolved[:k]), None)
    if twice is not None:
        raise InputError("strain.image_twice", file=twice)
    parts = 1
    while len({p.parts[-parts:] for p in resolved}) < len(resolved):
        parts += 1
    return ["/".join(p.parts[-parts:]) for p in resolved]


def _of_reference(s: StrainSettings, name: str, reference: Array, free: Mask) -> list[Message]:
    """What makes the reference, or what is masked of it, unfit."""
    import numpy as np

    from raybundle.matching.subsets import repetition

    found = list[Message]()
    correlation, period = repetition(reference)
    if correlation > REPEATED:
        found.append(warning("strain.repeated", name=name, correlation=correlation, period_px=period))
    ends = np.isin(reference[free], (reference.min(), reference.max()))
    if float(ends.mean()) > SATURATED:
        found.append(warning("strain.saturated", name=name, share=float(ends.mean()), limit=SATURATED))
    if s.mask is not None and free.all():
        found.append(warning("strain.mask_empty", name=s.mask.name))
    several = [p.name for p in (s.reference, *s.deformed) if _pages(p) > 1]
    if several:
        found.append(warning("strain.pages", names=several))
    return found


def _pages(path: Path) -> int:
    """Pictures of a file."""
    from PIL import Image

    try:
        with Image.open(path) as picture:
            return int(getattr(picture, "n_frames", 1))
    except (OSError, ValueError):  # of a kind that another library reads
        return 1


def _reported(s: StrainSettings, grid: SubsetGrid, images: Sequence[StrainImage]) -> tuple[Message, ...]:
    """What the results do not show, of the image of which it is most true."""
    import numpy as np

    from raybundle.matching.subsets import jumps

    found = list[Message]()
    pairs = [jumps(grid, i.followed) for i in images]
    shares = [n / max(of, 1) for n, of in pairs]
    if max(shares) > JUMPING:
        k = int(np.argmax(shares))
        jump = warning("strain.jumps", name=images[k].name, n=pairs[k][0], of=pairs[k][1], share=shares[k])
        found.append(replace(jump, severity=Severity.FAULT))
    uneven = {(n, i.name): a.misfit for i in images for n, a in i.areas.items() if a and a.misfit > UNEVEN}
    if uneven:
        area, name = max(uneven, key=lambda k: uneven[k])
        areas = sorted({n for n, _ in uneven})
        found.append(warning("strain.area_uneven", area=area, name=name, misfit=uneven[area, name], n=len(areas)))
    same = [i.name for i in images if _exact(i)]
    if same:
        found.append(warning("strain.same_content", names=same))
    lost = [int((~np.isfinite(i.followed.correlation)).sum()) for i in images]
    if any(lost):
        worst = images[int(np.argmax(lost))]
        reasons = [f"{n} {state}" for state, n in state_counts(worst.followed).items() if state != "followed"]
        found.append(warning("strain.not_followed", name=worst.name, images=sum(n > 0 for n in lost), n=max(lost),
                             of=len(worst.displacement), states=reasons))  # fmt: skip
    bent = [
        float((i.followed.parts_px > BENT_PX).sum() / max(len(i.displacement) - n, 1))
        for i, n in zip(images, lost, strict=True)
    ]
    if s.shape == "affine" and max(bent) > BENT_SHARE:
        worst = images[int(np.argmax(bent))]
        found.append(warning("strain.bent", name=worst.name, share=max(bent), limit_px=BENT_PX))
    for area in sorted({n for i in images for n, a in i.areas.items() if a is None}):
        lacking = [i.name for i in images if i.areas[area] is None]
        found.append(warning("strain.area_empty", area=area, names=lacking))
    none = [i.name for i in images if not np.isfinite(i.strain.strain).any()]
    if none:
        found.append(warning("strain.no_strain", names=none, gauge=s.gauge))
    return tuple(found)


def _exact(image: StrainImage) -> bool:
    """Whether an image is the reference, moved or not: no camera repeats a picture without noise."""
    import numpy as np

    cov = image.followed.cov_px2[:, 0, 0]
    return bool(np.nanmedian(cov) < EXACT_PX**2) if np.isfinite(cov).any() else False


def summary_of(image: StrainImage) -> list[Message]:
    """How far a specimen has moved, and by how much it is strained."""
    import numpy as np

    f, e = image.followed, image.strain
    if not np.isfinite(f.correlation).any():
        return []
    sigma = np.sqrt(np.nanmedian(np.diagonal(f.cov_px2, axis1=1, axis2=2), axis=0))
    shift, rotation = image.rigid.shift.tolist(), float(np.degrees(image.rigid.rotation))
    found = [
        note("strain.displacements", name=image.name, n=int(np.isfinite(f.correlation).sum()), of=len(f.state),
             sigma_px=float(np.sqrt(np.mean(sigma**2)))),
        note("strain.motion", u_px=shift[0], v_px=shift[1], rotation_deg=rotation),
    ]  # fmt: skip
    if np.isfinite(e.strain).any():
        xx, yy, xy = (1e6 * np.nanmedian(e.strain, axis=0)).tolist()
        largest = float(1e6 * np.nanquantile(e.principal[:, 0], LARGEST))
        std = 1e6 * float(np.sqrt(np.nanmedian(np.diagonal(e.cov, axis1=1, axis2=2))))
        found.append(note("strain.strains", xx=xx, yy=yy, xy=xy, sigma=std, largest=largest))
    for name, a in image.areas.items():
        if a is not None:
            (xx, yy, xy), s = (1e6 * a.strain.strain[0]).tolist(), 1e6 * np.sqrt(np.diag(a.strain.cov[0]))
            n = int(a.strain.count[0])
            if a.misfit > UNEVEN:  # one strain with a standard deviation would contradict the warning
                found.append(note("strain.area_not_one", name=name, n=n, xx=xx, yy=yy, xy=xy, misfit=a.misfit))
                continue
            found.append(note("strain.area", name=name, n=n, xx=xx, yy=yy, xy=xy, s_xx=float(s[0]), s_yy=float(s[1]),
                              s_xy=float(s[2])))  # fmt: skip
    return found
