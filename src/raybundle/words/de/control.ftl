control-own_measurements = Die Datei hat eigene Messungen; { $measurements } kann nicht hinzukommen.
    .do = Eine Messdatei nur zu einer CSV mit Punkten angeben.

control-no_coordinate = Punkt { $point } hat keine Koordinate.
    .do = Eine angeben oder die Zeile löschen.

control-normal = Punkt { $point }: nX, nY, nZ sind unvollständig oder alle 0.
    .do = Die drei Komponenten eines Vektors angeben.

control-none_in_block = Der Block hat weder Passpunkte noch Kontrollpunkte.
    .do = Einen Block mit Punkten der Rolle control oder check angeben.
