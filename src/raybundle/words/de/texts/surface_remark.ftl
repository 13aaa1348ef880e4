surface_remark-heights_relative = Höhen in { $system } sind relativ: Die Passpunkte haben keine gemessenen Höhen.

surface_remark-outside = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } ({ PERCENT($share) } %) { $n ->
        [one] liegt
        *[other] liegen
    } außerhalb der Fläche der Höhen, der der Verknüpfungspunkte.
    .do = { OPTION("extent", $x_min, $y_min, $x_max, $y_max) } setzen, um alle bis auf 0,1 % an jedem Rand einzuschließen.

surface_remark-remade = { $n } { $n ->
        [one] Produkt
        *[other] Produkte
    } früherer Läufe, beschädigt oder fehlend, neu erzeugt: { LIST($kinds, most: 12) }.

surface_remark-memory = { OPTION("memory") } erlaubt { NUM($memory_gb, digits: 2) } GB; die Tiefenkarte von { $name } braucht etwa { NUM($needed_gb, digits: 2) } GB.
    .why = Die Karten werden einzeln erzeugt.

surface_remark-earlier = { LIST($names, most: 12) }: aus einem früheren Lauf, aus denselben Punkten.

surface_remark-otherwise_thinned = { LIST($names, most: 12) }: aus einem früheren Lauf, { $length ->
        [0] nicht ausgedünnt
        *[other] ausgedünnt mit { NUM($length, digits: 12) }
    }; points.ply ist { $now ->
        [0] nicht ausgedünnt
        *[other] ausgedünnt mit { NUM($now, digits: 12) }
    }.
    .do = Beide mit { OPTION($setting) } gleich schreiben.

surface_remark-removed = { LIST($names, most: 12) }: entfernt, weil aus anderen Punkten gemacht.
    .do = Mit { OPTION($setting) } neu schreiben.

surface_remark-fine_cells = Eine Zelle von { NUM($cell) } ist schmaler als zwei Punktabstände (je { $density } × { NUM($pixel) }); manche haben keine Höhe.
    .do = { OPTION("dsm", $least) } setzen, damit die meisten Zellen eine haben.

surface_remark-no_depth = Darin wurde { $region ->
        [yes] innerhalb des Gebiets
        *[no] {""}
    } keine Tiefe gefunden.

surface_remark-too_few_confirmed = Andere Tiefenkarten bestätigen { PERCENT($share) } % seiner Tiefen; nötig sind { PERCENT($needed) } %.
