surface_files-correlation = { $correlation } ist keine Korrelation zwischen 0 und 1.

surface_files-unit_unknown = Die Einheit { $unit } der Höhen ist unbekannt.
    .do = Eine von { $known } angeben.

surface_files-size_differs = Das Raster hat { $columns } x { $rows } Zellen; in { $about } stehen { $needed_columns } x { $needed_rows }.
    .do = Die Dateien verwenden, wie surface sie schrieb; nur Kopien zuschneiden oder umwandeln.

surface_files-place_differs = Im Raster ist { $quantity ->
        [left] der linke Rand
        [top] der obere Rand
        [width] die Breite einer Zelle
       *[height] die Höhe einer Zelle
    } { NUM($value, digits: 12) }; in { $about } steht { NUM($needed, digits: 12) }.
    .do = Die Dateien verwenden, wie surface sie schrieb; nur Kopien zuschneiden oder umwandeln.

surface_files-rotated = Die Zeilen des Rasters sind gegen die Achsen gedreht; { $about } enthält keine Drehung.
    .do = Die Dateien verwenden, wie surface sie schrieb; nur Kopien zuschneiden oder umwandeln.

surface_files-system_differs = Das Raster ist in { $system }; in { $about } steht { $needed }.
    .do = Die Dateien verwenden, wie surface sie schrieb; nur Kopien zuschneiden oder umwandeln.

surface_files-other_surface = Die Datei gehört zu einer anderen Oberfläche als { $about }: Die Prüfsumme weicht ab.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-infinite_heights = { $n } { $n ->
        [one] Zelle hat
       *[other] Zellen haben
    } eine unendliche Höhe.
    .do = Dort NaN schreiben oder surface mit denselben Einstellungen neu ausführen.

surface_files-impossible_sigmas = { $n } von { $cells } Zellen mit Höhe haben eine unmögliche Standardabweichung ({ $band }).
    .why = Negativ: { $negative }; unendlich: { $infinite }; null: { $zero }; fehlend: { $missing }.
    .do = Diese Höhen auf NaN setzen oder surface mit denselben Einstellungen neu ausführen.

surface_files-block_size = Die Orientierung der Höhen hat Blöcke von { $cells } Zellen.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-node_count = Die Datei hat { $nodes } Knoten; zu Höhen mit { $rows } Zeilen und { $columns } Spalten gehören { $needed }.
    .why = Die Datei gehört zu einer anderen Oberfläche.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-not_finite = Die Datei enthält einen Wert, der keine endliche Zahl ist.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-other_holes = Die gefüllten Lücken in der Datei gehören zu einer anderen Oberfläche.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-no_heights = Der Ordner hat keine Datei { $name }; es wurde kein Höhenraster geschrieben.
    .do = surface mit { OPTION("dsm") } ausführen.

surface_files-node_dimensions = Die Knoten haben { $dimensions } Dimensionen; nötig sind 3 oder 4.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-bands_differ = { $sigmas } hat { $n } Kanäle; zu { $heights } gehören { $needed }.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-units_differ = Die Einheiten sind verschieden: hier { $unit ->
        [free] freier Maßstab
       *[other] { $unit }
    }, in { $other } { $other_unit ->
        [free] freier Maßstab
       *[other] { $other_unit }
    }.
    .do = Oberflächen von Ergebnissen mit gleicher Einheit verwenden.

surface_files-cells_differ = Die Oberfläche hat Zellen von { $cell }, { $other } von { $other_cell }.
    .do = Beide mit gleich großen Zellen berechnen.

surface_files-entry_missing = Die Datei hat keinen Eintrag { $name }.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-damaged = Die Datei ist beschädigt.
    .do = surface mit denselben Einstellungen neu ausführen.

surface_files-vertical_datums_differ = Die Höhenbezüge sind verschieden: { $system ->
    [none] eine Oberfläche
   *[other] { $system }
} ({ $datum ->
        [unknown] kein Höhenbezug
        [ellipsoid] ellipsoidische Höhen
       *[other] { $datum }
    }), { $other_system ->
    [none] eine Oberfläche
   *[other] { $other_system }
} ({ $other_datum ->
        [unknown] kein Höhenbezug
        [ellipsoid] ellipsoidische Höhen
       *[other] { $other_datum }
    }).
    .why = Differenzen dieser Höhen enthielten den Unterschied der Höhenbezüge.
    .do = Beide Oberflächen aus Ergebnissen in einem System von Lage und Höhe berechnen: { OPTION("crs", "EPSG:PLAN+HEIGHT") } von orient.

surface_files-one_in_map = { $map ->
        [yes] Diese Oberfläche ist in Landeskoordinaten, { $other } auf einer Ebene des Objekts
       *[no] Diese Oberfläche ist auf einer Ebene des Objekts, { $other } in Landeskoordinaten
    }.
    .why = Die Höhen der beiden Oberflächen haben verschiedene Bezüge.
    .do = Beide Oberflächen in Landeskoordinaten berechnen oder über derselben Ebene mit denselben Passpunkten.

surface_files-systems_differ = Die Oberflächen sind in verschiedenen Koordinatensystemen: { $system } und { $other }.
    .do = Beide in einem Koordinatensystem berechnen.

surface_files-plane_unknown = Die Ebene dieser Oberfläche oder von { $other } ist nicht bekannt.
    .do = Beide Oberflächen neu berechnen, über derselben Ebene mit denselben Passpunkten.

surface_files-planes_differ = Die Ebenen dieser Oberfläche und von { $other } weichen um { $off_cells } Zellen ab (Grenze { $limit_cells }).
    .why = Die Höhen der beiden Oberflächen haben verschiedene Bezüge.
    .do = Beide Oberflächen über derselben Ebene (gemeinsame Punkte oder Landeskoordinaten) mit denselben Passpunkten berechnen.
