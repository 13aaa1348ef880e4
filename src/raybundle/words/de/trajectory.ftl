trajectory-no_attitudes = Die Trajektorie hat keine Drehungen.
    .do = Ein Format nur mit Positionen verwenden.

trajectory-attitude_reference = Die Drehungen beziehen sich auf { $true_north ->
        [yes] Gitternord
       *[no] geographisch Nord
     }; diese Tabelle braucht { $true_north ->
        [yes] geographisch Nord
       *[no] Gitternord
     }.
    .do = Ein anderes Format wählen.

trajectory-format_unknown = Das Format der Datei ist nicht erkennbar.
    .do = Eine Tabelle mit imagename,latitude,longitude,altitude beginnen oder eines von { LIST($known, most: 20) } verwenden.

trajectory-count_differs = Positionen ohne Namen: { $positions }; Aufnahmen: { $photographs }.
    .do = Genau die Aufnahmen dieser Auslösungen angeben.

trajectory-position_twice = Die Position { $name } gehört zu { $first } und zu { $second }.
    .do = Für jeden Flug eine eigene Datei angeben.

trajectory-no_photograph_found = Keine der { $n } Aufnahmen hat hier eine Position.
    .why = Die erste Aufnahme ist { $photograph }, der erste Name der Datei { $name }.
    .do = Die Namen berichtigen.

trajectory-needs_local_frame = Die Positionen sind Länge und Breite; nötig ist ein lokales System.
    .do = Das lokale System des Blocks angeben.

trajectory-north_needs_frame = Drehungen gegen geographisch Nord brauchen ein Koordinatensystem.
    .do = Das lokale System des Blocks angeben.

trajectory-no_crs = Die Datei hat Gitterkoordinaten ohne Koordinatensystem.
    .do = { OPTION("crs", "EPSG:25832") } oder die Spalten longitude_deg, latitude_deg, height_m angeben.

trajectory-no_position = Die Datei enthält keine Position.
    .do = Prüfen, ob es die richtige Datei ist; eine Zeile ist NAME X Y Z oder NAME BREITE LÄNGE HÖHE.
