fiducial-one_coordinate = Rahmenmarke { $name } in Bild { $image } hat nur eine Koordinate.
    .do = x und y angeben oder keines von beiden, um sie zu entfernen.

fiducial-not_measured = Rahmenmarke { $name } ist in Bild { $image } nicht gemessen.
    .do = x und y angeben, um sie zu messen.

fiducial-too_few = Scan { $image }: { $n } Rahmenmarken sind gemessen; nötig sind { $least }.
    .why = Die übrigen werden dann automatisch gefunden.
    .do = { $least } messen, die nicht auf einer Geraden liegen.

fiducial-unknown_model = model = { $model } ist unbekannt.
    .do = similarity oder affine schreiben.

fiducial-not_calibrated = Rahmenmarke { $name } hat keine kalibrierte Position.
    .do = Eine von { LIST($known, most: 8) } verwenden.

fiducial-no_film = Diese Aufnahmen sind keine Scans von Film: Keine Rahmenmarke hat eine kalibrierte Position.
    .do = Das Projekt mit einem Kalibrierschein beginnen: { OPTION("film", "CERTIFICATE") }.

fiducial-no_scans = Die Aufnahmen sind keine Scans von Film und haben keine Rahmenmarken.
    .do = Bei Scans von Film das Projekt mit einem Kalibrierschein beginnen: { OPTION("film", "CERTIFICATE") }.
