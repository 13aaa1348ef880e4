photograph-empty = Die Datei ist leer.
    .do = Die Datei erneut von der Kamera kopieren.

photograph-kind_unknown = Das ist kein unterstütztes Bildformat (der Anfang ist { $begin }).
    .do = In JPEG, PNG oder TIFF umwandeln.

photograph-video = Das ist ein Video.
    .do = Seine scharfen Bilder mit raybundle frames entnehmen.

photograph-anymap = Das ist eine Portable Anymap (PGM, PPM) ohne Metadaten.
    .do = Verlustfrei als PNG oder TIFF speichern.

photograph-header_unreadable = Der Bildkopf ist nicht lesbar ({ $detail }).
    .do = Die Datei erneut kopieren.

photograph-tiff_pixels = Ein TIFF mit { $bands } Kanälen, { $bits } Bit, { $format ->
        [whole] ganze Zahlen
        [signed] ganze Zahlen mit Vorzeichen
        [floating] Gleitkommazahlen
       *[other] anderes Zahlenformat
     }{ $planar ->
        [yes] , Kanal nach Kanal
       *[no] { "" }
     }, wird nicht unterstützt.
    .do = 8-Bit-Farbe oder einen Kanal mit 8 oder 16 Bit schreiben (gdal_translate -ot Byte -scale, -b BAND).

photograph-no_size = Der Bildkopf nennt { $width_px } x { $height_px } px.
    .do = Die Datei erneut kopieren.

photograph-too_large = Das Bild hat { $width_px } x { $height_px } px, { $megapixels } Megapixel (Grenze { $limit_megapixels }).
    .do = Es verkleinern oder teilen.

photograph-package_missing = Dieses Format braucht ein zusätzliches Paket.
    .do = Ausführen: pip install 'raybundle[{ $extra }]'

photograph-bits = Das Bild hat { $bits } Bit je Kanal; unterstützt werden 8 und 16.
    .do = Es umwandeln.

photograph-pixels_unreadable = Die Pixel sind nicht dekodierbar ({ $detail }).
    .do = { $disk ->
        [yes] Den Datenträger oder die Speicherkarte prüfen
       *[no] Die Datei erneut kopieren
     }.

photograph-pixels_16_bit = Die 16-Bit-Pixel sind nicht dekodierbar.
    .do = Die Datei als 8-Bit-TIFF oder PNG speichern.

photograph-copy = Der Inhalt ist identisch mit { $original }.
    .do = Eine der beiden Dateien löschen.

photograph-too_small = Das Bild hat { $width_px } x { $height_px } px, zu wenig für Messungen.
    .do = Die Aufnahme in voller Größe verwenden.

photograph-no_content = { $width_px } x { $height_px } px in { $size_bytes } Bytes: Das ist keine Aufnahme.
    .do = Die Datei entfernen.

photograph-thumbnail = Das Bild ist ein Vorschaubild mit { $width_px } x { $height_px } px; die übrigen haben { $typical_megapixels } Megapixel.

photograph-size_changed = Das Bild hat { $width_px } x { $height_px } px; sein Kopf nennt { $header_width_px } x { $header_height_px }.
    .why = Die Datei wurde wahrscheinlich während des Laufs ersetzt.
    .do = Den Lauf wiederholen.

photograph-changed = Die Datei wurde während des Laufs durch eine andere ersetzt.
    .do = Den Lauf wiederholen.

photograph-none_oriented = Noch ist keine Aufnahme orientiert.
    .do = Die unten genannten Punkte messen.

photograph-lacks_fiducials = Scan { $image }: { $n } Rahmenmarken sind gemessen; nötig sind { $least }.
    .do = Weitere Rahmenmarken messen.

photograph-film_contradicts = Scan { $image }: Die Rahmenmarken passen nicht ({ $detail }).
    .do = Die Rahmenmarken nochmals messen.

photograph-lacks_marks = Aufnahme { $image }: { $n ->
        [0] Kein Punkt ist darin markiert
       *[other] Keiner ihrer { $n } Punkte ist in einer anderen markiert
     }.
    .do = { $least } Punkte in beiden markieren.

photograph-lacks_common = Die Aufnahmen { $image } und { $other } haben { $n } gemeinsame Punkte; nötig sind { $least }.
    .do = Mehr Punkte in beiden markieren.

photograph-lacks_known = Aufnahme { $image } zeigt { $n } Punkte mit Koordinaten; nötig sind { $least }.
    .do = Mehr Punkte mit Koordinaten markieren.

photograph-lacks_base = Aufnahmen { $image } und { $other }: Die Strahlen zu ihren { $n } Punkten sind parallel.
    .why = Diese Aufnahmen wurden vom selben Standpunkt aufgenommen.
    .do = Punkte in einer Aufnahme von einem anderen Standpunkt markieren.

photograph-lacks_fit = Aufnahme { $image }: Keine Orientierung passt zu ihren { $n } Punkten.
    .do = Namen und Bildmessungen der Punkte prüfen und weitere Punkte markieren.

photograph-size_of_calibration = Die Aufnahme hat { $width_px } x { $height_px } px, die Kalibrierung { $camera_width_px } x { $camera_height_px } px.
    .do = Eine Aufnahme des Kalibriersatzes angeben.

photograph-folder_unknown = Der Ordner der Aufnahmen ist unbekannt.
    .do = { OPTION("photos", "FOLDER") } angeben.

photograph-too_few = Aufnahmen in diesem Ordner: { $n }; nötig sind zwei.
    .why = { $unreadable ->
        [0] { "" }
       *[other] Nicht lesbare Dateien: { $unreadable } ({ LIST($names, most: 3) }).
     }
    .do = Den Pfad prüfen.

photograph-none = Hier ist keine Aufnahme.
    .do = Aufnahmen oder Ordner mit Aufnahmen angeben.

photograph-other_size = Die Datei hat { $width_px } x { $height_px } px, ihr Bild im Block { $block_width_px } x { $block_height_px } px.
    .why = Das ist eine andere Aufnahme.
    .do = Die Aufnahme angeben, die für den Block verwendet wurde.

photograph-not_in_result = Nicht im Ergebnis: { $names }.
    .do = Aufnahmen des Ergebnisses angeben.

photograph-no_longer_readable = Aufnahmen wurden während des Laufs unlesbar.
    .do = Das Laufwerk oder Netzlaufwerk prüfen und neu starten.

photograph-too_few_usable = { $n } brauchbare { $n ->
        [one] Aufnahme
       *[other] Aufnahmen
    }; mindestens { $least } { $least ->
        [one] ist
       *[other] sind
    } nötig.
    .do = Einen Ordner mit Aufnahmen oder ihre Dateien angeben.

photograph-in_no_folder = Die Datei ist in keinem der Ordner der Aufnahmen.

photograph-none_readable = Keine Aufnahme des Blocks ist lesbar.
    .do = Den Ordner der Aufnahmen prüfen.

photograph-map_raster = Ein Gleitkommaraster ({ $bits } Bit) in einer Karte enthält Höhen oder Ergebnisse, keine Aufnahme.
    .do = Ist es eine Aufnahme, ihre Lage in der Karte entfernen (gdal_edit.py -unsetgt).

photograph-not_fetched = Die Datei war in { $n } Versuchen nicht zu holen ({ $detail }).
    .do = Denselben Befehl erneut ausführen, wenn der Dienst antwortet.

photograph-unknown_scheme = Über dieses Protokoll werden keine Aufnahmen gelesen.
    .do = Eine URL mit einem von diesen angeben: { $known }.
