colmap-blank_in_name = Bild { $image } hat ein Leerzeichen im Namen; Textdateien von COLMAP können es nicht darstellen.
    .do = Das binäre Format (colmap) schreiben oder die Aufnahmen umbenennen.

colmap-no_model = Der Ordner hat kein COLMAP-Modell.
    .do = Einen Ordner mit cameras, images und points3D angeben, alle .bin oder alle .txt.

colmap-file_missing = Die Datei fehlt; { $other } braucht sie.
    .do = Die Datei in den Ordner kopieren.

colmap-camera_line = Eine Kamera braucht Nummer, Modell, Breite, Höhe und Parameter.
    .do = Diese Zeile vervollständigen.

colmap-image_line = Ein Bild braucht Nummer, 4 + 3 Zahlen, Kamera und Name.
    .do = Diese Zeile vervollständigen.

colmap-image_points_line = Die Zeile der Bildpunkte hat { $n } Zahlen; jeder Punkt braucht drei: x, y und Punktnummer.
    .do = Diese Zeile korrigieren oder das Modell erneut aus COLMAP ausgeben.

colmap-point_line = Ein Punkt braucht Nummer, 3 Koordinaten, 3 Farben und einen Fehler.
    .do = Diese Zeile vervollständigen.
