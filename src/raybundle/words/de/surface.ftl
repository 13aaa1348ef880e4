surface-points = Oberfläche: { $n } Punkte aus { $maps } { $maps ->
        [one] Tiefenkarte
        *[other] Tiefenkarten
    }.

surface-precision = Standardabweichung eines Punktes: { NUM($median, digits: 2) } { $free_scale ->
        [yes] Einheiten (Median, Maßstab willkürlich)
        *[no] { $unit } (Median)
    }.

surface-precision_of_axes = Median der Standardabweichungen: X { $x }, Y { $y }, Z { $z }, längs des Strahls { $along_ray } { $unit }.

surface-shares = Varianz längs des Strahls: Rauschen { $noise } %, Rauheit { $roughness } %, Orientierung { $orientation } %.

surface-plane_without_heights = { OPTION($setting) } gehört zu einem Höhenraster; keines ist verlangt.
    .do = { OPTION("dsm", "CELL") }, { OPTION("ortho", "CELL") }, { OPTION("mesh", "CELL") } oder { OPTION("region") } angeben.

surface-foreign_file = Der Ordner enthält { $name }, das nicht zu einer Oberfläche gehört.
    .do = { OPTION("out") } anders wählen.

surface-no_point_above_area = Kein Punkt der Oberfläche liegt über dem Gebiet der Höhen.
    .do = Ein anderes Gebiet wählen.

surface-scale_free = Der Maßstab des Blocks ist nicht bestimmt; eine Oberfläche hat keine Längeneinheit.
    .do = Mit einer Maßstabsstrecke, zwei Passpunkten oder beobachteten Positionen ausgleichen oder { OPTION("free_scale", "True") } angeben.

surface-mesh_empty = Kein Dreieck der Seite { $side } hat Höhen an allen Ecken.
    .do = Ein anderes Gebiet oder { OPTION("mesh") } wählen.

surface-region_too_small = Das Gebiet von { $width } x { $height } ist kleiner als der Punktabstand von { $apart }.
    .do = Ein größeres Gebiet oder eine andere { OPTION("density") } angeben.

surface-region_not_readable = { OPTION("region", $given) } ist weder eine Datei noch eine Folge von mindestens drei Ecken.
    .do = { $rectangle ->
        [yes] Ein Rechteck als { OPTION("extent") } oder Ecken als X Y, X Y, X Y angeben
       *[no] Ecken als X Y, X Y, X Y angeben
    }.

surface-too_many_cubes = { OPTION("thin", $side) } teilt die Oberfläche in mehr als { $most } Würfel.
    .do = Mehr als { NUM($least, digits: 2) } angeben.

surface-orthophoto_not_shown = Keine Aufnahme zeigt das Gebiet des Orthophotos.
    .do = Ein anderes Gebiet wählen.

surface-region_not_shown = Keine Aufnahme, die Tiefen misst, zeigt das Gebiet.
    .why = Es ist { NUM($left, digits: 10) } bis { NUM($right, digits: 10) } und { NUM($bottom, digits: 10) } bis { NUM($top, digits: 10) } in der Ebene.
    .do = Ein anderes Gebiet angeben.

surface-no_pair = Keine zwei Aufnahmen können Tiefen messen.
    .do = Aufnahmen hinzufügen, die denselben Teil des Objekts von verschiedenen Orten zeigen.

surface-too_few_photographs = { $n } { $n ->
        [one] Aufnahme des Ergebnisses ist
       *[other] Aufnahmen des Ergebnisses sind
    } verfügbar; eine Oberfläche benötigt { $least }.
    .do = Den Ordner der Aufnahmen angeben: { OPTION("photos", "FOLDER") }.

surface-photographs_lost = { $n } von { $photographs } ausgeglichenen Aufnahmen sind nicht verwendbar.
    .why = Die Oberfläche hat Lücken, wo nur sie etwas zeigen.
    .do = Den Ordner der Aufnahmen mit { OPTION("photos", "ORDNER") } angeben.

surface-nothing_measured = { $region ->
        [yes] Im Gebiet wurde nichts gemessen
       *[no] Es wurde nichts gemessen
    }: { PERCENT($share) } % von { $pixels } Pixeln haben eine Tiefe, keine bestätigt.
    .why = Himmel, Wasser, Glas, einfarbige Wände und Bewegtes haben keine beständige Textur.
    .do = Texturierte Oberflächen mit 60 % Überdeckung oder mehr aufnehmen.

surface-region_invalid = { OPTION("region", $given) } ist kein gültiges Gebiet.
    .do = Die Ecken der Reihe nach angeben, ohne sich kreuzende Kanten.

surface-no_depth_map = Es ließ sich keine Tiefenkarte berechnen.
    .do = Die folgende Ursache beheben, dann surface erneut ausführen.

surface-other_photographs = { $region ->
        [yes] Im Gebiet wurde nichts gemessen
       *[no] Es wurde nichts gemessen
    }: Aufnahmen weichen von den orientierten ab.
    .why = { PERCENT($share) } % von { $pixels } Pixeln haben eine Tiefe, von anderen Aufnahmen nicht bestätigt.
    .do = Die orientierten Aufnahmen angeben: { OPTION("photos", "FOLDER") }, oder die vorhandenen neu orientieren.

surface-photographs_replaced = { $n } { $n ->
        [one] Aufnahme ist nicht die Datei, die orientiert wurde
        *[other] Aufnahmen sind nicht die Dateien, die orientiert wurden
    }: { $names }.
    .why = Tiefen sind falsch oder fehlen, wo Pixel verschieden sind.
    .do = Die ursprünglichen Dateien wiederherstellen.

surface-photographs_exchanged = { $n } { $n ->
        [one] Aufnahme enthält
        *[other] Aufnahmen enthalten
    } das Bild einer anderen (Datei: Bild): { $names }.
    .why = Diese Aufnahmen werden mit falscher Orientierung verwendet; Tiefen sind falsch.
    .do = Den Dateien ihre ursprünglichen Namen geben, dann surface erneut ausführen.
