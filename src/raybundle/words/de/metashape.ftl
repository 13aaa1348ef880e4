metashape-no_calibration = Kein Sensor hat eine Kalibrierung.
    .do = Die Aufnahmen in Metashape ausrichten und neu exportieren.

metashape-p3_p4 = Der Verzeichnungsparameter { $parameter } wird nicht unterstützt.
    .do = Ohne p3 und p4 kalibrieren.

metashape-sizes_differ = Die Kalibrierung hat { $width_px } x { $height_px } px, ihr Sensor { $sensor_width_px } x { $sensor_height_px } px.
    .do = Mit Aufnahmen in voller Größe kalibrieren und neu exportieren.

metashape-no_similarity = Das ist keine Ähnlichkeitstransformation: Der Maßstabsfaktor muss positiv, die Drehmatrix orthogonal sein.
    .do = Die Datei neu exportieren.

metashape-cameras_disabled = Alle Kameras sind deaktiviert.
    .do = Die gewünschten Kameras aktivieren und neu exportieren.

metashape-no_calibrated_camera = Keine Kamera hat einen kalibrierten Sensor.
    .do = Die Aufnahmen in Metashape ausrichten und neu exportieren.

metashape-unit_length = Die Länge der Einheit ist keine positive Zahl.
    .do = Das Koordinatensystem des Chunks korrigieren und neu exportieren.
