tiff-ends_early = Die TIFF-Datei endet vor Byte { $byte }.
    .do = Die Datei erneut kopieren.

tiff-no_tiff = Die Datei ist keine TIFF-Datei.
    .do = Eine TIFF-Datei angeben oder das Bild in TIFF umwandeln.

tiff-too_many_tags = Das TIFF-Verzeichnis hat { $n } Tags; höchstens { $most } werden gelesen.
    .do = Prüfen, ob die Datei beschädigt ist.

tiff-pixel_format = Die Pixel haben { $bits } Bit, Sample-Format { $format }; unterstützt werden ganze Zahlen mit 8 oder 16 Bit.
    .do = Die Datei umwandeln, zum Beispiel mit gdal_translate -ot UInt16.

tiff-directory_damaged = Im TIFF-Verzeichnis fehlen Größen oder Positionen der Pixel.
    .do = Die Datei erneut kopieren.

tiff-too_few_tiles = Die TIFF-Datei hat { $n } Streifen oder Kacheln; nötig sind { $needed }.
    .do = Die Datei erneut kopieren.

tiff-pixels_end_early = Die Pixel der TIFF-Datei enden zu früh.
    .do = Die Datei erneut kopieren.

tiff-pixels_unreadable = Die Pixel sind nicht dekodierbar (Kompression { $compression }, Kanäle { $bands }, Bit { $bits }).
    .do = Die Datei umwandeln, zum Beispiel mit gdal_translate -co COMPRESS=NONE.

tiff-compression = Die Pixel sind nach Verfahren { $compression } komprimiert; dafür ist das Extra [geo] nötig.
    .do = Es installieren (pip install 'raybundle[geo]') oder die Datei mit gdal_translate -co COMPRESS=DEFLATE schreiben.
