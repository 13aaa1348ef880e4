area-none = Die Datei hat kein Polygon, keine Linie und keinen Punkt.
    .do = Eine Datei mit einem davon angeben.

area-too_many_points = Der Umriss hat { $n } Punkte; höchstens { $most } werden gelesen.
    .do = Den Umriss vereinfachen.

area-no_position = { $text } ist keine geographische Position (Länge,Breite).
    .do = Die Datei korrigieren.

area-not_readable = Die Datei ist nicht als Linien oder Flächen lesbar ({ $detail }).
    .do = Das Gebiet als GeoJSON, KML oder GeoPackage speichern.

area-damaged = Eine Geometrie der Datei ist beschädigt.
    .do = Die Datei neu exportieren.

area-no_utm = Das Gebiet liegt bei { NUM($latitude_deg, decimals: 1) }° geographischer Breite, außerhalb von UTM.
    .do = Ein Koordinatensystem in Metern angeben.

area-not_degrees = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } sind nicht geographische Länge und Breite in Grad.
    .do = Das Koordinatensystem des Gebiets angeben, geographische Länge vor Breite.

area-outside_system = { NUM($x, decimals: 2) }, { NUM($y, decimals: 2) } liegt außerhalb von { $system }.
    .do = Das Koordinatensystem prüfen.
