control_file-no_sigma = { $name } enthält keine Standardabweichungen; angenommen werden { NUM($off_mm, digits: 2) } mm, wie die Punkte zum Netz passen.
    .do = sX, sY, sZ angeben, wenn sie bekannt sind.

control_file-not_measured = { $n } { $n ->
        [one] Passpunkt wurde
       *[other] Passpunkte wurden
     } nicht gemessen: { LIST($ids, most: 10) }.
    .why = Das Ergebnis hat keine Koordinaten dieser Punkte, und sie stützen es nicht.
    .do = Diese Punkte in mindestens zwei Aufnahmen messen oder aus der Datei löschen.

control_file-tolerance = Die Spalte tolerance in { $name } wird nicht verwendet: Toleranzen gehören zu Sollkoordinaten.
    .why = Das Gewicht der Passpunkte folgt allein aus ihren Standardabweichungen.
    .do = Standardabweichungen in den Spalten sX, sY, sZ angeben.

control_file-tolerance_unused = Die Spalte tolerance der Passpunkte wird nicht verwendet: Toleranzen gehören zu Sollkoordinaten.
    .do = Standardabweichungen in den Spalten sX, sY, sZ angeben.

control_file-words_behind_names = { $name }: Wörter nach dem Namen des Punktes sind in { $n } { $n ->
     [one] Zeile
     *[other] Zeilen
    } nicht gelesen.
    .why = Die ersten sind { $words } nach { $point } in Zeile { $line_number }.
    .do = Enthalten Punktnamen Leerzeichen, die Spalten durch Tabulatoren trennen.

control_file-no_names = Die Datei hat keine Punktnamen; Zeilen mit demselben X Y Z sind ein Punkt: { LIST($names, most: 2) } ...

control_file-sigma_assumed = Koordinaten ohne Standardabweichung: { $plan }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } in der Lage und { $height }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } in der Höhe angenommen.

control_file-heights_unknown = { $name }: Alle { $n } Höhen sind { NUM($height, digits: 10) } und gelten als unbekannt.
    .why = Die Punkte werden nur in der Lage verwendet.
    .do = Wurden diese Höhen gemessen, eine CSV-Datei mit einer Spalte sZ angeben.

control_file-system_of_others = Koordinatensystem von { $name }: nicht angegeben; { $system } angenommen, wie in { $others }.

control_file-cartesian_assumed = Koordinatensystem von { $name }: nicht angegeben; kartesische Koordinaten in Metern angenommen.
    .why = Koordinaten wie { NUM($x, digits: 10) }, { NUM($y, digits: 10) } sind wohl Landeskoordinaten.
    .do = In diesem Fall { OPTION("crs", "EPSG:CODE") } angeben.

control_file-system_given = Koordinatensystem von { $name }: nicht in der Datei angegeben; { $system } nach { OPTION("crs") }.

control_file-degrees = Koordinaten wie { NUM($x, digits: 8) }, { NUM($y, digits: 8) } scheinen Länge und Breite zu sein.
    .why = Es ist kein Koordinatensystem angegeben: sie würden als Meter gelten.
    .do = In eine Kartenprojektion umrechnen; `orient` nimmt sie auch mit { OPTION("crs", "EPSG:4979") } (Höhen über dem Ellipsoid).
