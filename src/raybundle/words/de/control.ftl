control-own_measurements = Die Datei hat eigene Bildmessungen; { $measurements } kann nicht hinzukommen.
    .do = Eine Messdatei nur zu einer CSV mit Punkten angeben.

control-no_coordinate = Punkt { $point } hat keine Koordinate.
    .do = Eine angeben oder die Zeile löschen.

control-normal = Punkt { $point }: nX, nY, nZ sind unvollständig oder alle 0.
    .do = Die drei Komponenten eines Vektors angeben.

control-none_in_block = Der Block hat weder Passpunkte noch Kontrollpunkte.
    .do = Einen Block mit Punkten der Rolle control oder check angeben.

control-one_place = Alle { $n } Passpunkte haben dieselben Koordinaten ({ LIST($coordinates, most: 3) }): { $names }.
    .why = Passpunkte an einer Stelle bestimmen weder Richtung noch Maßstab.
    .do = Jedem Punkt seine eigenen Koordinaten geben; wahrscheinlich wurde eine Zeile kopiert.

control-several_systems = Die Passpunkte liegen in verschiedenen Koordinatensystemen vor: { $systems }.
    .do = Die Passpunkte in ein System umrechnen.

control-too_few_measured = Passpunkte mit zwei oder mehr Strahlen: { $n }; mindestens { $least } sind nötig.
    .do = Mehr davon in den Aufnahmen messen oder Positionen und ein Koordinatensystem der Passpunkte angeben.

control-point_twice = Der Punkt { $point } steht auch in { $table }.
    .why = Ein Punkt ist entweder Passpunkt oder Kontrollpunkt.
    .do = Einen von beiden anders benennen oder löschen.

control-other_photographs = Keine der Aufnahmen, in denen die Datei Punkte misst, ist dabei.
    .why = Die Datei hat { LIST($names, most: 3) }; vorhanden sind { LIST($photographs, most: 3) }.
    .do = Prüfen, ob die Datei zu diesen Aufnahmen gehört, und die Namen prüfen.

control-points_in_line = Die { $n } gemessenen Passpunkte liegen auf einer Geraden oder sind ein Punkt: { LIST($points, most: 5) }.
    .do = Das Datum durch drei Passpunkte festlegen, die nicht auf einer Geraden liegen.

control-other_unit = Die Maßstabsstrecken machen das Netz { NUM($ratio, digits: 4) }-mal so groß wie die Passpunkte.
    .why = Die Einheit von einem der beiden ist falsch{ $likely ->
        [yes] { " " }(vermutlich { $units })
       *[no] { "" }
     }.
    .do = Die Einheit der Passpunktdatei angeben: { OPTION("unit") }.

control-none_in_photograph = Kein Punkt mit X und Y ist in { $photograph } gemessen.
    .do = Prüfen, ob die Bildnamen übereinstimmen.

control-too_few_for_datum = { $n } von { $total } Punkten sind gemessene Passpunkte mit X, Y und Z; ein Datum braucht drei.
    .do = Passpunkte nach den Codes ihrer Zielmarken benennen.
