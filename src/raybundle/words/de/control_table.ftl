control_table-no_coordinates = { $table }: Keine Zeile hat eine Koordinate.
    .do = Spalten point, X, Y, Z schreiben; wahlweise sX, sY, sZ, role.

control_table-point_twice = { $table }: Punkt { $point } kommt mehrfach vor.
    .do = Nur eine Zeile davon behalten.

control_table-not_readable = { $table } lässt sich nicht als Tabelle lesen ({ $detail }).
    .do = Prüfen, ob es eine CSV-Tabelle ist.
