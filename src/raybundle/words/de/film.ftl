film-mark_outside_camera = { $x_mm }, { $y_mm } mm liegt außerhalb jeder Kamera (größter Wert { $largest_mm } mm).
    .do = Millimeter angeben.

film-mark_not_calibrated = Die Marke { $mark } hat keine kalibrierte Position.
    .do = Ihren Namen berichtigen ({ LIST($known, most: 8) }) oder sie im Zertifikat ergänzen.

film-position_outside_scan = { $x_px }, { $y_px } px liegt außerhalb jedes Scans (größter Wert { $largest_px } px).
    .do = Die Messung berichtigen.

film-pixel_size = Bild { $image }: Ein Scannerpixel von { $pixel_mm } mm ist nicht möglich.
    .do = Die Größe in mm angeben.

film-too_few_marks = Bild { $image } hat { $n } Marken; die Transformation { $model } braucht { $needed }.
    .do = Mehr Marken messen oder eine einfachere Transformation verwenden.

film-marks_in_line = Bild { $image }: Die Marken liegen auf einer Geraden oder an einer Stelle.
    .why = Die Transformation { $model } ist nicht bestimmt.
    .do = Über das Bild verteilte Marken messen.

film-too_few_crosses = Das Réseau hat { $n } Kreuze; eine Korrektur braucht { $needed }.
    .do = Mehr Kreuze messen oder das Réseau weglassen.

film-no_marks = Bild { $image } hat Punkte, aber keine Marken.
    .do = Seine Rahmenmarken messen.

film-marks_implausible = Bild { $image }: Kein Film hat die Verformung, die diese Marken zeigen.
    .why = Die Transformation würde alle Bildpunkte verfälschen; dieser Scan wird nicht transformiert.
    .do = Die Marken wie unten beschrieben berichtigen, dann die Scans erneut transformieren.

film-no_transformation = Bild { $image }: Keine Transformation { $model } passt zu den Marken.
    .do = Die Marken wie unten beschrieben berichtigen, dann die Scans erneut transformieren.

film-residuals = Residuen der Rahmenmarken erreichen { $worst_mm } mm nach der Transformation (Grenze { $limit_mm } mm).
    .do = Namen, gemessene und kalibrierte Positionen der Marken vergleichen.

film-stretch = Die Marken würden den Film entlang einer Achse { $ratio }-mal so stark dehnen wie entlang der anderen (Grenze { $limit }).
    .do = Namen, gemessene und kalibrierte Positionen der Marken vergleichen.

film-shear = Die Marken würden den Film scheren: Die Achsen weichen um { $shear_deg }° vom rechten Winkel ab (Grenze { $limit_deg }°).
    .do = Namen, gemessene und kalibrierte Positionen der Marken vergleichen.

film-marks_exchanged = Die Namen zweier Marken sind wahrscheinlich vertauscht: { $pairs }.
    .do = Diese Namen tauschen.

film-wrong_mark = Die Marke { $mark } liegt { $offset_mm } mm neben der Stelle, die die anderen ergeben.
    .do = Sie neu messen oder ihre kalibrierte Position berichtigen.

film-several_wrong_marks = Mehr als eine Marke ist falsch.
    .do = Namen, kalibrierte und gemessene Positionen vergleichen.

film-camera_missing = Filmscans brauchen eine kalibrierte Kamera.
    .do = Ihr Kalibrierprotokoll angeben: { OPTION("calibration", "CAMERA") }.

film-scans_not_transformed = Scans, die sich nicht transformieren lassen: { $n }. Nichts wird geschrieben.
    .do = Die Marken dieser Scans wie unten beschrieben berichtigen oder ihre Zeilen löschen.

film-one_camera = Angegebene Kameras: { $n }; Scans von Film benötigen genau eine, die Kamera des Films.
    .do = Eine Kamera angeben: { OPTION("calibration", "CAMERA") }.
