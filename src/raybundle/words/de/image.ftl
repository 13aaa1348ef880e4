image-unknown_camera = Bild { $image } verweist auf Kamera { $camera }, die fehlt.
    .do = Die Nummer korrigieren oder die Kamera ergänzen.

image-point_not_finite = Bild { $image }: Ein Bildpunkt ist nicht endlich.
    .do = Die Datei neu exportieren.

image-in_two_frames = Bild { $image } steht in zwei Frames.
    .do = Das Modell neu exportieren.

image-camera_differs = Bild { $image } hat die Kamera { $camera }, in seinem Frame aber { $frame_camera }.
    .do = Das Modell neu exportieren.

image-angles_incomplete = Bild { $image } hat { $n } von 3 Winkeln.
    .do = Alle drei oder keinen angeben.

image-held_without_orientation = Bild { $image } ist festgehalten, aber seine äußere Orientierung ist unvollständig.
    .do = Die Orientierung vervollständigen oder die Spalte held leer lassen.

image-file_frame_incomplete = Bild { $image } hat { $n } von { $columns }.
    .do = Alle drei oder keine angeben.

image-scan_incomplete = Bild { $image } ist ein Scan, aber nicht alle seine Spalten haben Werte.
    .do = { LIST($needed, most: 12) } ausfüllen oder keine davon.

image-affine_singular = Bild { $image }: Die affine Transformation des Scans ist nicht umkehrbar.
    .do = Die Rahmenmarken neu messen.

image-file_size_differs = Bild { $image }: Eine Datei von { NUM($width_px, digits: 6) } x { NUM($height_px, digits: 6) } px passt nicht zu { $camera_width_px } x { $camera_height_px } px.
    .why = Die Kamera hat dieses Format; die Datei ist um { $turned_deg }° gedreht.
    .do = Größe oder Drehung korrigieren.

image-points_in_line = Alle Objektpunkte von { $n } { $n ->
        [one] Bild
       *[other] Bildern
     } liegen auf einer Geraden: { LIST($images, most: 5) }.
    .why = Innerhalb von { $limit_sigmas } Standardabweichungen kann sich das Bild um diese Gerade drehen.
    .do = Punkte neben der Geraden messen, Projektionszentren beobachten oder das Bild weglassen.

image-too_few_points = { $n } { $n ->
        [one] Bild hat
       *[other] Bilder haben
     } zu wenige Bildpunkte: { $images }.
    .why = Eine äußere Orientierung braucht mindestens drei.
    .do = Dort mehr Punkte messen oder die Bilder weglassen.

image-points_and_unknowns = Bilder { $images }: { $n } { $n ->
        [one] Bildpunkt
        *[other] Bildpunkte
    } für { $unknowns } Unbekannte.

image-not_oriented = Bild { $image } hat keine äußere Orientierung.
    .do = Es zuerst orientieren.

image-photograph_missing = Bild { $image }: Seine Aufnahme ist nicht in den Ordnern des Projekts.
    .do = Die Aufnahme wiederherstellen.
