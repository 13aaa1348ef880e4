axes-point_missing = Koordinatensystem: Der { $which ->
        [origin] Ursprung
       *[axis] Achspunkt
     } fehlt.
    .do = Ursprung und Achse angeben; einen Ebenenpunkt ergänzen, wenn weder ein Horizont noch eine Lotlinie die Lotrichtung bestimmt.

axes-same_points = Koordinatensystem: Zwei der Punkte { $names } sind gleich.
    .do = Verschiedene Punkte angeben.

axes-in_line = Koordinatensystem { $names }: Die Punkte liegen auf einer Geraden.
    .why = Der Sinus des Winkels am Ursprung ist { NUM($sine, digits: 2) } (Grenze { $limit }).
    .do = Einen Ebenenpunkt neben der Achse wählen.

axes-vertical = Koordinatensystem { $names }: Die Punkte liegen übereinander, ohne Richtung in der Lage.
    .why = Der Sinus des Winkels zur Lotrichtung ist { NUM($sine, digits: 2) } (Grenze { $limit }).
    .do = Einen anderen Achspunkt wählen.

axes-level_no_plane = Horizont { $names }: Die { $n } Punkte bestimmen keine Ebene.
    .why = Es sind zu wenige, oder sie liegen auf einer Geraden (Breite durch Länge { NUM($width, digits: 2) }, Grenze { $limit }).
    .do = Mindestens drei Punkte angeben, die nicht auf einer Geraden liegen.

axes-no_coordinates = Koordinatensystem { $names }: Punkt { $point } hat keine Koordinaten.
    .do = Den Punkt in zwei Bildern messen.

axes-contradicts_block = Das Koordinatensystem der Punkte { $names } widerspricht dem Datum des Blocks ({ $tables }).
    .do = Eines von beiden entfernen oder das Ergebnis transformieren (raybundle datum).

axes-no_vertical = Das Koordinatensystem der Punkte { $names } hat keine Lotrichtung.
    .do = Einen Horizont oder eine Lotlinie messen oder einen dritten Punkt in der XY-Ebene angeben.

axes-plane_or_level = Koordinatensystem: { $both ->
        [yes] Ein Ebenenpunkt und die Punkte eines Horizonts sind angegeben
       *[no] Weder ein Ebenenpunkt noch die Punkte eines Horizonts sind angegeben
     }.
    .do = Eines davon angeben.

axes-point_count = Angegebene Punkte: { $n }; ein Koordinatensystem braucht drei, zwei oder keinen.
    .why = Zwei genügen, wo Horizonte oder Lotlinien die Lotrichtung festlegen.
    .do = Ursprung, Achse und Ebene, oder Ursprung und Achse, oder keinen angeben.
