wpl-no_header = Die erste Zeile ist nicht { $head }; das ist keine Wegpunktliste.
    .do = Prüfen, ob es die richtige Datei ist.
