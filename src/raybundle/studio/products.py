"""What is made of a result from the page: surface, drawing, sections, volumes, exchange files, archive; and its files.

A product is a command: the page shows a form of its settings, and runs it as it is typed.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

from starlette.concurrency import run_in_threadpool
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse, Response
from starlette.routing import Route

from raybundle.commands.archive import ArchiveSettings
from raybundle.commands.convert import ConvertSettings
from raybundle.commands.facade import FacadeSettings
from raybundle.commands.heights.contours import HeightsContoursSettings
from raybundle.commands.heights.drawing import HeightsDrawingSettings
from raybundle.commands.heights.section import HeightsSectionSettings
from raybundle.commands.heights.volume import HeightsVolumeSettings
from raybundle.commands.surface import SurfaceSettings
from raybundle.errors import InputError, phrase
from raybundle.pipeline.project import StageRecord
from raybundle.settings import as_typed
from raybundle.studio.deciding import PAGE_POLICY
from raybundle.studio.desk import Desk
from raybundle.studio.forms import fields_of, settings_of_form, table_of
from raybundle.studio.guard import POLICY_HEADER
from raybundle.studio.pictures import Pictures
from raybundle.studio.running import Running
from raybundle.surfaces.files.heights import HEIGHTS

EXPORTS, SURFACE = "exports", "surface"
"""Folders of what is made, in that which is open"""
SHOWN = {"surface": "surface", "facade*": "facade", EXPORTS: "exports", "result": "result"}
"""Folders whose files are listed, and what they are called"""
APART = frozenset({"work", "cache", "block"})
"""Folders within them that hold nothing to look at"""
MOST_FILES = 500
"""That are listed"""


@dataclass(frozen=True, slots=True, kw_only=True)
class Product:
    """A command of which something comes that one hands over."""

    name: str
    command: tuple[str, ...]
    settings: type[Any]
    shown: tuple[str, ...]
    """settings in the form"""
    of: str = ""
    """folder within what is open that it reads; empty: what is open"""
    out: tuple[str, ...] = ()
    """new files in EXPORTS, with {n} for the next free number; empty: the command has its own place"""
    many: bool = False
    """whether `out` of the command takes several files"""
    usual: tuple[tuple[str, Any], ...] = ()
    """settings that are other than those of the command"""
    drawn: str = ""
    """setting that takes the corners of what is drawn on a picture"""
    progress: bool = True
    """whether the command shows it"""
    photos: bool = False
    """whether it takes folders of photographs"""


PRODUCTS = {p.name: p for p in (
    Product(
        name="surface", command=("surface",), settings=SurfaceSettings, photos=True,
        shown=("density", "dsm", "ortho", "mesh", "las", "extent", "thin", "vertical", "pdf", "free_scale"),
    ),
    Product(
        name="facade", command=("facade",), settings=FacadeSettings, photos=True,
        shown=("wall", "pixel", "density", "fill", "scale", "paper", "grid", "section", "extent"),
    ),
    Product(
        name="volume", command=("heights", "volume"), settings=HeightsVolumeSettings, of=SURFACE,
        shown=("outline", "above", "fill", "most_filled"), drawn="outline", progress=False,
    ),
    Product(
        name="section", command=("heights", "section"), settings=HeightsSectionSettings, of=SURFACE,
        shown=("line", "step", "between", "fill"), drawn="line", progress=False, many=True,
        out=("section-{n}.svg", "section-{n}.csv", "section-{n}.dxf"),
    ),
    Product(
        name="contours", command=("heights", "contours"), settings=HeightsContoursSettings, of=SURFACE,
        shown=("interval", "rough", "fill"), progress=False, many=True,
        out=("contours-{n}.svg", "contours-{n}.dxf", "contours-{n}.geojson"),
    ),
    Product(
        name="drawing", command=("heights", "drawing"), settings=HeightsDrawingSettings, of=SURFACE,
        shown=("layer", "fill"), progress=False, many=True, out=("drawing-{n}.dxf", "drawing-{n}.gpkg"),
    ),
    Product(
        name="exchange", command=("convert",), settings=ConvertSettings, out=("exchange-{n}",), usual=(("to", "gpkg"),),
        shown=("to", "crs", "undulation", "undistort", "approximate", "free_scale"),
    ),
    Product(
        name="archive", command=("archive",), settings=ArchiveSettings, out=("archive-{n}.zip",),
        shown=("with_photographs", "with_surface"),
    ),
)}  # fmt: skip


@dataclass(frozen=True, slots=True, kw_only=True)
class Making:
    """A product with its settings: one of `running.Runs`."""

    product: Product
    settings: Any

    @property
    def name(self) -> str:
        """Of the product."""
        return self.product.name

    @property
    def words(self) -> list[str]:
        """Of the command line, without the program."""
        return [*self.product.command, *as_typed(self.settings), "--", str(self.settings.source)]

    @property
    def command(self) -> str:
        """As it is typed."""
        return shlex.join(["raybundle", *self.words])

    @property
    def child_words(self) -> list[str]:
        """The same for a child, which shows its progress where it has any."""
        n = len(self.product.command)
        return [*self.words[:n], *(("--progress", "json") if self.product.progress else ()), *self.words[n:]]

    @property
    def titles(self) -> tuple[str, ...]:
        """Nothing: its steps are shown as they go."""
        return ()

    @property
    def origin(self) -> None:
        """Nothing: what is open stays as it is."""
        return

    def records(self) -> list[StageRecord]:
        """Nothing."""
        return []

    def check(self) -> None:
        """Raise InputError where what it reads is missing; make the folder of what it writes."""
        p, source = self.product, Path(self.settings.source)
        if p.of and not (source / HEIGHTS).is_file():
            raise InputError("product.needs_heights", command=shlex.join(["raybundle", *p.command]), folder=str(source))
        if p.out:
            folder = _exports(source.parent if p.of else source)
            try:
                folder.mkdir(exist_ok=True)
            except OSError as error:
                raise InputError(
                    "file.not_writable", detail=error.strerror or str(error), refused=True, file=folder
                ) from None


def _exports(source: Path) -> Path:
    return source / EXPORTS


def _usual(p: Product, desk: Desk) -> Any:
    """Its settings as they are before anyone changes them; new files under a name that is free."""
    source = desk.source
    given: dict[str, Any] = {"source": source / p.of if p.of else source, **dict(p.usual)}
    if p.photos and desk.photos:
        given["photos"] = tuple(desk.photos)
    if p.out:
        folder, n = _exports(source), 1
        stem = p.out[0].partition("{")[0]
        taken = {f.name.removeprefix(stem).partition(".")[0] for f in folder.glob(f"{stem}*")}
        while str(n) in taken:
            n += 1
        names = tuple(folder / name.format(n=n) for name in p.out)
        given["out"] = names if p.many else names[0]
    return p.settings(**given)


@dataclass(slots=True)
class Products:
    """What the page asks and does."""

    desk: Desk
    running: Running
    pictures: Pictures

    @property
    def gets(self) -> dict[str, Callable[[Mapping[str, Any]], Any]]:
        """Questions, by their paths."""
        return {
            "/api/products": lambda _: {"products": list(PRODUCTS), "files": self.listed(), "run": self._run()},
            "/api/product": lambda q: self._form(_product(q.get("name")), {}),
            "/api/picture": lambda q: self.pictures.about(self._file(str(q.get("file", "")))),
            "/api/picture/place": lambda q: self.pictures.place(self._file(str(q.get("file", ""))), q),
        }

    @property
    def posts(self) -> dict[str, Callable[[dict[str, Any]], Any]]:
        """Deeds, by their paths."""
        return {
            "/api/product/settings": lambda given: self._form(_product(given.get("name")), table_of(given, "values")),
            "/api/product/make": self._make,
        }

    @property
    def pages(self) -> list[Route]:
        """Files, and parts of pictures."""
        return [
            Route("/product/file/{path:path}", self._send, methods=["GET"]),
            Route("/product/picture/{path:path}", self._part, methods=["GET"]),
        ]

    def listed(self) -> list[dict[str, Any]]:
        """The files that are there, by folder; the first MOST_FILES of each."""
        found: list[dict[str, Any]] = []
        for folder, kind in self._folders():
            files = [*_files(folder)]
            found.append({
                "folder": folder.name, "kind": kind, "more": max(0, len(files) - MOST_FILES),
                "files": [
                    {"path": f.relative_to(self.desk.source).as_posix(), "name": f.relative_to(folder).as_posix(),
                     "bytes": f.stat().st_size, "picture": self.pictures.is_picture(f),
                     "page": f.suffix.lower() == ".html"}
                    for f in files[:MOST_FILES]
                ],
            })  # fmt: skip
        return found

    def _folders(self) -> Iterator[tuple[Path, str]]:
        for pattern, kind in SHOWN.items():
            for folder in sorted(self.desk.source.glob(pattern)):
                if folder.is_dir() and not folder.is_symlink():
                    yield folder, kind

    def _file(self, path: str) -> Path:
        """A file that is listed; everything else is none."""
        name, _, inner = path.partition("/")
        for folder, _ in self._folders():
            if folder.name == name and _is_listed(folder, inner):
                return folder / inner
        raise HTTPException(404, phrase("studio_page.no_page"))

    def _run(self) -> dict[str, Any] | None:
        run = self.running.run
        return run.reported() if run is not None and isinstance(run.what, Making) else None

    def _making(self, p: Product, values: Mapping[str, Any]) -> Making:
        usual = _usual(p, self.desk)
        own = {f.name: getattr(usual, f.name) for f in fields(usual)}
        apart = {name for name in own if name not in p.shown}
        return Making(product=p, settings=settings_of_form(p.settings, values, own, apart))

    def _form(self, p: Product, values: Mapping[str, Any]) -> dict[str, Any]:
        made, usual = self._making(p, values), _usual(p, self.desk)
        plain = {f["name"]: f["value"] for f in fields_of(usual)}
        shown = {f["name"]: {**f, "default": plain[f["name"]]} for f in fields_of(made.settings)}
        if p.name == "exchange":
            from raybundle.workflows.convert import WRITABLE

            shown["to"] |= {"kind": "choice", "choices": sorted(WRITABLE)}
        return {
            "name": p.name, "fields": [shown[name] for name in p.shown], "command": made.command, "drawn": p.drawn,
            "run": self._run(),
        }  # fmt: skip

    def _make(self, given: dict[str, Any]) -> dict[str, Any]:
        p = _product(given.get("name"))
        self.running.begin(self._making(p, table_of(given, "values")))
        return {"run": self._run()}

    async def _send(self, request: Request) -> Response:
        file = await run_in_threadpool(self._file, request.path_params["path"])
        if file.suffix.lower() == ".html":
            return FileResponse(file, media_type="text/html; charset=utf-8", headers={POLICY_HEADER: PAGE_POLICY})
        kind = "inline" if file.suffix.lower() in {".svg", ".png", ".jpg", ".jpeg", ".pdf"} else "attachment"
        return FileResponse(
            file, filename=file.name, content_disposition_type=kind, headers={POLICY_HEADER: PAGE_POLICY}
        )

    async def _part(self, request: Request) -> Response:
        body = await run_in_threadpool(
            lambda: self.pictures.part(self._file(request.path_params["path"]), request.query_params)
        )
        return Response(body, media_type="image/png", headers={"cache-control": "private, max-age=60"})


def _product(name: object) -> Product:
    found = PRODUCTS.get(str(name))
    if found is None:
        raise HTTPException(400, phrase("studio_page.bad_request", name="name", kind="text"))
    return found


def _is_listed(folder: Path, inner: str) -> bool:
    """Whether `_files` of a folder has a file, without a look at all others: parts of pictures are asked for often."""
    parts = inner.split("/")
    entries = [folder.joinpath(*parts[: k + 1]) for k in range(len(parts))]
    odd = any(not p or p.startswith(".") or "\0" in p for p in parts) or bool(APART & {*parts[:-1]})
    try:
        return not odd and not any(e.is_symlink() for e in entries) and entries[-1].is_file()
    except OSError:  # a name that is too long
        return False


def _files(folder: Path) -> Iterator[Path]:
    """The files of a folder in which something is to be looked at; nothing that a link leads to."""
    for entry in sorted(folder.iterdir()):
        odd = any("\ud800" <= c <= "\udfff" for c in entry.name)  # bytes that are no text
        if odd or entry.name.startswith(".") or entry.is_symlink():
            continue
        if entry.is_file():
            yield entry
        elif entry.is_dir() and entry.name not in APART:
            yield from _files(entry)
