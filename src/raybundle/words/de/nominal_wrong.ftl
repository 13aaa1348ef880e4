nominal_wrong = { $wrong } { $wrong ->
        [one] gemessener Punkt weicht
       *[other] gemessene Punkte weichen
     } weit stärker vom Soll ab als die übrigen: { $ids }.
    .why = Die übrigen stimmen auf { NUM($rms_mm, digits: 2) } mm (rms) überein; die Achsen sind { $excluded ->
        [yes] ohne sie
       *[no] mit ihnen, wie gewählt,
     } eingepasst.
    .do = Sollkoordinaten und Namen dieser Punkte prüfen.
