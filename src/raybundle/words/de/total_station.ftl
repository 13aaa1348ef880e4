total_station-vertical_sight = Satz { $set } in directions.csv: { $station } und { $target } haben in points.csv dieselbe Lage.
    .why = Eine Horizontalrichtung zwischen ihnen ist nicht definiert.
    .do = Die Koordinaten beider Punkte korrigieren oder die Richtung löschen.
