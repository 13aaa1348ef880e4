binary-ends_in_record = Die Datei endet innerhalb eines Datensatzes (Byte { $byte }).
    .do = Die vollständige Datei beschaffen.

binary-number_not_finite = { $kind ->
        [camera] Kamera
        [image] Bild
        [point] Punkt
        [rig] Rig
       *[frame] Frame
     } { $number }: Eine Zahl ist nicht endlich oder zu groß (Byte { $byte }).
    .do = Die Datei neu exportieren.

binary-count_too_large = Die Datei kündigt { $n } { $kind ->
        [cameras] Kameras
        [images] Bilder
        [image_points] Bildpunkte
        [points] Punkte
        [track_elements] Elemente von Bildpunktfolgen
        [rigs] Rigs
       *[frames] Frames
     } an; sie hat Platz für { $most } (Byte { $byte }).
    .do = Die vollständige Datei beschaffen.

binary-name_too_long = Ein Name ist länger als { $most } Bytes (Byte { $byte }).
    .do = Prüfen, ob die Datei beschädigt ist.

binary-name_not_utf8 = Ein Name ist nicht UTF-8 (Byte { $byte }).
    .do = Prüfen, ob die Datei beschädigt ist.

binary-bytes_left = Auf den letzten Datensatz folgen { $n } Bytes (Byte { $byte }).
    .why = Die Datei hat wahrscheinlich eine andere Version des Formats.
    .do = Die Datei neu exportieren.
