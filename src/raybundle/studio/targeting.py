"""The routes of the page of targets: what is found in the photographs, and the sheet to print."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from raybundle.commands.target_settings import SheetSettings, run_sheet
from raybundle.errors import phrase
from raybundle.io.reading.trees import read_json
from raybundle.results.project_results import own_result
from raybundle.settings import as_typed
from raybundle.studio.desk import Desk
from raybundle.studio.detecting import Detecting
from raybundle.studio.forms import fields_of, settings_of_form, table_of

SHEET = SheetSettings(target="aicon14", codes="1-50", paper="A3", out=Path("sheet.pdf"))
"""What the form begins with: the sheet of the how-to on calibration."""
APART = ("table", "bits", "out")
KINDS = {".pdf": "application/pdf", ".toml": "application/toml"}


@dataclass(slots=True)
class Targeting:
    """What the page asks and does."""

    desk: Desk
    detecting: Detecting
    sheet: SheetSettings = SHEET
    printed: dict[str, bytes] = field(default_factory=dict[str, bytes])
    """the last sheet: name of the file -> content"""

    @property
    def gets(self) -> dict[str, Callable[[Mapping[str, Any]], Any]]:
        """Questions, by their paths."""
        return {
            "/api/targets": lambda q: self.detecting.overview(self._families(q)),
            "/api/targets/image": lambda q: self.detecting.of_image(str(q.get("image", "")), self._families(q)),
            "/api/sheet": lambda _: self._form(),
        }

    @property
    def posts(self) -> dict[str, Callable[[dict[str, Any]], Any]]:
        """Deeds, by their paths."""
        return {"/api/targets": self._begin, "/api/sheet": self._print}

    @property
    def pages(self) -> list[Route]:
        """The printed sheet, to be kept as a file."""
        return [Route("/sheet/{name}", self._file, methods=["GET"])]

    def _families(self, q: Mapping[str, Any]) -> str:
        """As they are asked for, or as the result states that was opened."""
        if "families" in q:
            return " ".join(str(q["families"]).split())
        result = own_result(self.desk.source)
        if result is None:
            return ""
        tree = read_json(result / "result.json")
        families = tree.get("targets").get("families").items() if tree.has("targets") else []
        return " ".join(f.text() for f in families)

    def _begin(self, given: dict[str, Any]) -> dict[str, Any]:
        families, images = given.get("families", ""), given.get("images", [])
        if not isinstance(families, str) or not isinstance(images, list):
            raise HTTPException(400, phrase("studio_page.bad_request", name="images", kind="list"))
        return self.detecting.begin(" ".join(families.split()), [str(i) for i in images])  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]

    def _form(self) -> dict[str, Any]:
        command = ["raybundle", "targets", "sheet", *as_typed(self.sheet)]
        return {
            "fields": fields_of(self.sheet, apart=APART), "command": shlex.join(command),
            "files": [*self.printed],
        }  # fmt: skip

    def _print(self, given: dict[str, Any]) -> dict[str, Any]:
        """Make the sheet of these settings; raises InputError for what does not fit or go together."""
        stated = {k: v for k, v in table_of(given, "values").items() if v != ""}
        settings = settings_of_form(SheetSettings, stated, {"out": SHEET.out}, APART)
        with TemporaryDirectory() as folder:
            _, written = run_sheet(replace(settings, out=Path(folder) / SHEET.out))
            self.printed = {p.name: p.read_bytes() for p in written if p.suffix in KINDS}
        self.sheet = settings
        return self._form()

    async def _file(self, request: Request) -> Response:
        name = request.path_params["name"]
        body = self.printed.get(name)
        if body is None:
            raise HTTPException(404, phrase("studio_page.no_sheet"))
        headers = {"content-disposition": f'attachment; filename="{name}"'}  # a name of ours: sheet.pdf, sheet.toml
        return Response(body, media_type=KINDS[Path(name).suffix], headers=headers)
