calibration-no_list = { $value } ist keine Liste kalibrierter Parameter.
    .do = Eine Liste von Tabellen mit parameter, value, sigma und correlations angeben.

calibration-incomplete_entry = Eintrag { $number } ist kein kalibrierter Parameter.
    .do = parameter, value, sigma und als Liste correlations mit den Einträgen davor angeben.

calibration-correlation_count = Eintrag { $number } hat { $n } Korrelationen; nötig sind { $needed }, mit den Parametern davor.
    .do = Die Liste vervollständigen.

calibration-not_positive_definite = Die Korrelationen bilden keine positiv definite Matrix.
    .do = Sie berichtigen oder mit mehr Stellen schreiben.

calibration-format_differs = Gespeicherte Kalibrierung { $camera }: Keine Aufnahme hat ihr Format, { $width_px } x { $height_px } px.
    .do = Die Kalibrierung einer Kamera des Satzes angeben: { $known }.

calibration-several_cameras = Die gespeicherte Kalibrierung { $camera } passt zu { $n } Kameras.
    .do = Ihr die Kennung von einer davon geben: { $known }.

calibration-two_for_camera = Zwei gespeicherte Kalibrierungen passen zur Kamera { $camera }.
    .do = Jeder die Kennung ihrer Kamera geben: { $known }.
