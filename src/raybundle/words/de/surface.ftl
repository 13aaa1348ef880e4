surface-points = Oberfläche: { $n } Punkte aus { $maps } { $maps ->
        [one] Tiefenkarte
        *[other] Tiefenkarten
    }.

surface-photographs_missing = { $n } von { $of } ausgeglichenen Aufnahmen sind nicht verwendbar: { $names }.
    .why = Die Oberfläche hat Lücken, wo nur sie etwas zeigen.
    .do = Ihren Ordner mit { OPTION("photos", "ORDNER") } angeben.

surface-other_photographs = Aufnahmen sind nicht die Dateien, die orientiert wurden.
    .why = Tiefen sind falsch oder fehlen, wo die Pixel verschieden sind.
    .do = Die ursprünglichen Dateien und Namen wiederherstellen.

surface-precision = Standardabweichung eines Punktes: { NUM($median, digits: 2) } { $free_scale ->
        [yes] Einheiten (Median, Maßstab willkürlich)
        *[no] { $unit } (Median)
    }.

surface-precision_of_axes = Mediane Standardabweichung: X { $x }, Y { $y }, Z { $z }, längs des Strahls { $along_ray } { $unit }.

surface-shares = Varianz längs des Strahls: Rauschen { $noise } %, Rauheit { $roughness } %, Orientierung { $orientation } %.
