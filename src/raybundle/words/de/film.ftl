film-mark_outside_camera = { $x_mm }, { $y_mm } mm liegt außerhalb jeder Kamera (größter Wert { $largest_mm } mm).
    .do = Millimeter angeben.

film-mark_not_calibrated = Die Rahmenmarke { $mark } hat keine kalibrierte Position.
    .do = Den Namen der Rahmenmarke korrigieren ({ LIST($known, most: 8) }) oder sie im Kalibrierschein ergänzen.

film-position_outside_scan = { $x_px }, { $y_px } px liegt außerhalb jedes Scans (größter Wert { $largest_px } px).
    .do = Die Messung korrigieren.

film-pixel_size = Bild { $image }: Ein Scannerpixel von { $pixel_mm } mm ist nicht möglich.
    .do = Die Größe in mm angeben.

film-too_few_marks = Bild { $image } hat { $n } Rahmenmarken; die Transformation { $model } braucht { $needed }.
    .do = Mehr Rahmenmarken messen oder eine einfachere Transformation verwenden.

film-marks_in_line = Bild { $image }: Die Rahmenmarken liegen auf einer Geraden oder an einer Stelle.
    .why = Die Transformation { $model } ist nicht bestimmt.
    .do = Über das Bild verteilte Rahmenmarken messen.

film-too_few_crosses = Das Réseau hat { $n } Kreuze; eine Korrektur braucht { $needed }.
    .do = Mehr Kreuze messen oder das Réseau weglassen.

film-no_marks = Bild { $image } hat Punkte, aber keine Rahmenmarken.
    .do = Seine Rahmenmarken messen.

film-marks_implausible = Bild { $image }: Kein Film hat die Verformung, die diese Rahmenmarken zeigen.
    .why = Die Transformation würde alle Bildpunkte verfälschen; dieser Scan wird nicht transformiert.
    .do = Die Rahmenmarken wie unten beschrieben korrigieren, dann die Scans erneut transformieren.

film-no_transformation = Bild { $image }: Keine Transformation { $model } passt zu den Rahmenmarken.
    .do = Die Rahmenmarken wie unten beschrieben korrigieren, dann die Scans erneut transformieren.

film-residuals = Verbesserungen der Rahmenmarken erreichen { $worst_mm } mm nach der Transformation (Grenze { $limit_mm } mm).
    .do = Namen, gemessene und kalibrierte Positionen der Rahmenmarken vergleichen.

film-stretch = Die Rahmenmarken würden den Film entlang einer Achse { $ratio }-mal so stark dehnen wie entlang der anderen (Grenze { $limit }).
    .do = Namen, gemessene und kalibrierte Positionen der Rahmenmarken vergleichen.

film-shear = Die Rahmenmarken würden den Film scheren: Die Achsen weichen um { $shear_deg }° vom rechten Winkel ab (Grenze { $limit_deg }°).
    .do = Namen, gemessene und kalibrierte Positionen der Rahmenmarken vergleichen.

film-marks_exchanged = Die Namen zweier Rahmenmarken sind wahrscheinlich vertauscht: { $pairs }.
    .do = Diese Namen tauschen.

film-wrong_mark = Die Rahmenmarke { $mark } liegt { $offset_mm } mm neben der Stelle, die die anderen ergeben.
    .do = Die Rahmenmarke neu messen oder ihre kalibrierte Position korrigieren.

film-several_wrong_marks = Mehr als eine Rahmenmarke ist falsch.
    .do = Namen, kalibrierte und gemessene Positionen vergleichen.

film-camera_missing = Filmscans brauchen eine kalibrierte Kamera.
    .do = Den Kalibrierschein der Kamera angeben: { OPTION("calibration", "CAMERA") }.

film-scans_not_transformed = Scans, die sich nicht transformieren lassen: { $n }. Nichts wird geschrieben.
    .do = Die Rahmenmarken dieser Scans wie unten beschrieben korrigieren oder ihre Zeilen löschen.

film-one_camera = Angegebene Kameras: { $n }; Scans von Film benötigen genau eine, die Kamera des Films.
    .do = Eine Kamera angeben: { OPTION("calibration", "CAMERA") }.

film-as_many_marks = So viele Marken wie Unbekannte: eine falsche Marke fällt nicht auf.
    .do = Messen Sie mehr Marken oder wählen Sie eine einfachere Transformation.

film-mirrored = Bild { $image } ist gespiegelt.
    .why = Der Film wurde von hinten gescannt, oder zwei gegenüberliegende Marken sind vertauscht.
    .do = Scannen Sie den Film von vorn, oder tauschen Sie die beiden Marken.

film-shrinkage = Bild { $image }: der Film wäre um mehr als { PERCENT($limit) } % geschrumpft.
    .why = Das tut kein Film.
    .do = Prüfen Sie { OPTION("pixel_mm") }.

film-residuals_enlarged = Bild { $image }: die Verbesserungen der Marken sind { NUM($sigma0, digits: 3) }-mal so groß wie angegeben.
    .why = Die Standardabweichungen sind um diesen Faktor vergrößert.

film-suspects = Bild { $image }: Marken sind vielleicht falsch: { $marks }.
    .do = Messen Sie diese Marken neu.
