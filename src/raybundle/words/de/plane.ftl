plane-points_in_line = Ebene { $name }: Die Punkte liegen auf einer Geraden.
    .why = Die Ebene kann sich um diese Gerade drehen.
    .do = Einen Punkt neben der Geraden ergänzen.

plane-axes_not_orthogonal = right, up und normal sind keine rechtshändigen orthogonalen Einheitsvektoren (Abweichung { $deviation }, Grenze { $limit }).
    .do = Die Datei neu schreiben.

plane-place_unknown = Die Lage der Ebene im Raum ist unbekannt; right, up und normal fehlen.
    .do = Die Aufnahme erneut entzerren.

plane-other_unit = Die Einheit der Ebene ist { $plane }, die des Blocks { $block }.
    .do = Die Ebene eines Bildes dieses Blocks angeben.

plane-vertical_and_horizontal = Eine Ebene kann nicht { OPTION("vertical", "True") } und { OPTION("horizontal", "True") } sein.
    .do = Eines davon angeben.

plane-too_few_points = Die Ebene hat { $n } { $n ->
        [one] Punkt
       *[other] Punkte
    }; nötig sind { $least }.
    .do = { $vertical ->
        [yes] Mehr Punkte nennen
       *[no] Mehr Punkte nennen oder zwei mit { OPTION("vertical", "True") }
    }.

plane-point_twice = Punkt { $point } der Ebene ist zweimal genannt.
    .do = Einen anderen Punkt nennen.

plane-no_projected_system = { $system } ist kein projiziertes Koordinatensystem; ein Bildplan benötigt eines.
    .do = Ein projiziertes System angeben: { OPTION("crs") }.

plane-points_above_each_other = Die Punkte der Ebene liegen übereinander; eine lotrechte Ebene hat keine Richtung.
    .do = Einen Punkt daneben nennen.

plane-points_on_line = Die Punkte der Ebene liegen auf einer Geraden.
    .do = Andere Punkte nennen.

plane-axis_no_direction = { OPTION("axis", $first, $second) }: In der Ebene gesehen liegen die Punkte hintereinander.
    .do = Zwei Punkte wählen, die in der Ebene auseinanderliegen.

plane-leans = Die Punkte neigen sich { $back ->
        [yes] nach hinten
        *[no] nach vorn
    } um { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } Grad; keine Wand neigt sich um mehr als { NUM($limit_deg, digits: 2) } Grad.
    .do = Prüfen Sie einzeln, ob die Punkte in einer Wand liegen und ob die Lotrechte stimmt.

plane-not_plumb = Die Wand steht nicht lotrecht: ihre Punkte neigen sich { $back ->
        [yes] nach hinten
        *[no] nach vorn
    } um { NUM($lean_deg, digits: 2) }{ $sigma_known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } Grad.
    .why = Die Ebene ist wie verlangt lotrecht.

plane-no_such_wall = Die Punkte zeigen { $n } { $n ->
        [one] Wand
        *[other] Wände
    }, nicht { $wall }.
    .do = { OPTION("wall") } kleiner wählen oder Punkte der Wand nennen: { OPTION("plane", "A,B,C") }.
