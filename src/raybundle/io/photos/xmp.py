"""XMP packets: the entries of a few namespaces, read without DTD, entities or external references."""

from __future__ import annotations

from xml.parsers import expat

from raybundle.errors import phrase

PACKET_BYTES = 1 << 20
ENTRIES = 2000
VALUE_CHARACTERS = 10_000
PREFIXES = {
    "http://www.dji.com/drone-dji/1.0": "drone-dji",
    "http://ns.google.com/photos/1.0/panorama": "GPano",
    "http://ns.adobe.com/exif/1.0/aux": "aux",
    "http://ns.adobe.com/exif/1.0": "exif",
    "http://cipa.jp/exif/1.0": "exifEX",
    "http://ns.adobe.com/tiff/1.0": "tiff",
    "http://pix4d.com/camera/1.0": "Camera",
    "http://ns.adobe.com/xap/1.0": "xmp",
}


class _Refused(Exception):
    """The packet holds something that an XMP packet has no need of."""


def read_xmp(packet: bytes) -> tuple[dict[str, str], tuple[str, ...]]:
    """Entries by "prefix:name" of the namespaces in PREFIXES, and remarks on what could not be read.

    A property may stand as an attribute, as an element, or as the first item of an array.  What was read
    before an error stays.  ISO 16684-1.
    """
    packet = packet.strip(b"\0 \r\n\t")
    if len(packet) > PACKET_BYTES:
        return {}, (phrase("photo_entry.xmp_long", bytes=len(packet), most=PACKET_BYTES),)
    reader = _Reader()
    try:
        reader.parse(packet)
    except (expat.ExpatError, _Refused, ValueError, LookupError) as error:
        return reader.entries, (phrase("photo_entry.xmp_damaged", detail=str(error)),)
    return reader.entries, ()


class _Reader:
    """Expat's handlers and what they collect."""

    def __init__(self) -> None:
        self.entries: dict[str, str] = {}
        self.names: list[str] = []
        self.text: list[str] = []

    def parse(self, packet: bytes) -> None:
        """Fill `entries`."""
        parser = expat.ParserCreate(namespace_separator=" ")
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.StartDoctypeDeclHandler = self._doctype
        parser.EntityDeclHandler = self._doctype
        parser.SetParamEntityParsing(expat.XML_PARAM_ENTITY_PARSING_NEVER)
        parser.Parse(packet, True)

    @staticmethod
    def _doctype(*_: object) -> None:
        raise _Refused("a document type declaration is not allowed")

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self.names) > 50:
            raise _Refused("nested more than 50 deep")
        self.names.append(_known(name))
        self.text = []
        for key, value in attributes.items():
            self._enter(_known(key), value)

    def _characters(self, text: str) -> None:
        self.text.append(text)

    def _end(self, _: str) -> None:
        value = "".join(self.text).strip()
        self.text = []
        # an array item (rdf:li in rdf:Seq) belongs to the property three levels up; the first one is kept
        owner = next((n for n in self.names[:-4:-1] if n), "")
        self.names.pop()
        if value:
            self._enter(owner, value)

    def _enter(self, name: str, value: str) -> None:
        if name and len(self.entries) < ENTRIES and len(value) <= VALUE_CHARACTERS:
            self.entries.setdefault(name, value.strip())


def _known(name: str) -> str:
    """The name as prefix:name for a property of a known namespace, else empty."""
    space, _, local = name.rpartition(" ")
    prefix = PREFIXES.get(space.rstrip("/#"))
    return f"{prefix}:{local}" if prefix else ""
