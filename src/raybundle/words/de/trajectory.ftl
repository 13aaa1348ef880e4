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
    .do = Die Namen korrigieren.

trajectory-needs_local_frame = Die Positionen sind geographische Länge und Breite; nötig ist ein lokales System.
    .do = Das lokale System des Blocks angeben.

trajectory-north_needs_frame = Drehungen gegen geographisch Nord brauchen ein Koordinatensystem.
    .do = Das lokale System des Blocks angeben.

trajectory-no_crs = Die Datei hat ebene Koordinaten ohne Koordinatensystem.
    .do = { OPTION("crs", "EPSG:25832") } oder die Spalten longitude_deg, latitude_deg, height_m angeben.

trajectory-no_position = Die Datei enthält keine Position.
    .do = Prüfen, ob es die richtige Datei ist; eine Zeile ist NAME X Y Z oder NAME BREITE LÄNGE HÖHE.

trajectory-count = Tabelle { $table }: { $times } Zeiten und { $n } Einträge.
    .do = Von beiden gleich viele angeben, mindestens zwei.

trajectory-not_finite = Die Tabelle { $table } hat eine Zeit oder einen Wert, der keine endliche Zahl ist.
    .do = Die Tabelle korrigieren.

trajectory-time_order = Tabelle { $table }: Zeit { $time_s } s (Eintrag { $entry }) folgt auf { $before_s } s.
    .do = Die Einträge nach der Zeit ordnen und doppelte löschen.

trajectory-zero_quaternion = Ein Quaternion der Lagewinkel hat die Länge null.
    .do = Die Tabelle der Lagewinkel korrigieren.

trajectory-not_covered = Die Tabelle { $table } umfasst { $start_s } bis { $end_s } s, die Zeilen aber { $first_s } bis { $last_s } s.
    .why = Die Tabelle ist abgeschnitten, oder ihre Anfangszeit gehört zu einer anderen Szene.
    .do = Die vollständige Tabelle dieser Szene beschaffen.

trajectory-gap = Die Tabelle { $table } hat im Bild eine Lücke von { $gap_s } s, von { $start_s } bis { $end_s } s.
    .why = Der übliche Abstand ist { $usual_s } s.
    .do = Eine vollständige Tabelle beschaffen.

trajectory-degree = { $name } = { $degree } ist nicht möglich.
    .do = 0, 1, 2 oder -1 für keine angeben.

trajectory-parameter_count = Die Korrekturparameter haben die Dimension ({ $shape }); nötig sind { $needed }.
    .do = Für jeden Parameter einen Wert angeben.

trajectory-velocity_contradicts = Tabelle { $table }, Eintrag { $entry }: Geschwindigkeit { NUM($stated, digits: 4) } m/s; die Positionen ändern sich um { NUM($moved, digits: 4) } m/s.
    .do = Einheiten, Vorzeichen und Spalten der Geschwindigkeiten prüfen.

trajectory-undecided = Die Datei legt die Konvention dieser Spalten nicht fest: Möglich sind { $readings }.
    .do = Die Spalten mit ihrer Einheit benennen (omega_gon) oder { OPTION("attitudes", $first) } angeben. Vier oder mehr Aufnahmen entscheiden.

trajectory-scenes_apart = Szenen einer Trajektorie liegen { NUM($seconds, digits: 4) } s auseinander; möglich sind { NUM($limit_s, digits: 3) } s.
    .do = Szenen eines anderen Umlaufs oder Streifens eine eigene Trajektorie geben.

trajectory-no_scene = Keine Kamera nennt die Trajektorie { $name }.
    .do = trajectory = { $name } in die Tabellen ihrer Kameras schreiben, oder sie löschen.
