target_seen-corners_blurred = { $n } Ecken von { $target } zu sehen, keine scharf genug zum Messen.

target_seen-corners_missing = { $n } Ecken von { $target } zu sehen, { $least } sind nötig.

target_seen-few_corners = { $target } zu sehen, aber nur { $n } von { $of } Ecken sind messbar.
    .why = Die übrigen sind nicht scharf oder gleichmäßig genug.

target_seen-larger_board = Das Schachbrett hat mehr als { $columns } x { $rows } innere Ecken.
    .do = Die richtige Zahl angeben.

target_seen-no_board = Kein ganzes { $target } zu sehen{ $squares ->
        [yes] , aber eines mit so vielen Feldern: Es heißt { $named }
        *[no] {""}
    }.

target_seen-no_raster = Kein ganzes { $target } unter { $n } Punkten zu sehen.

target_seen-no_rings = { $n } Punkte im Raster zu sehen, aber nicht zwei Ringe mit ein bis vier Bögen.

target_seen-other_raster = Punkte in { $columns } Spalten und { $rows } Zeilen zu sehen, nicht { $target }.

target_seen-read_twice = Zielmarke { $target } ist an zwei Stellen zu lesen.

target_seen-tag_in_places = Marke { $tag } ist an { $n } Stellen zu sehen: ihre Ecken haben keinen Namen.

target_seen-two_boards = { $target } ist an zwei Stellen zu sehen, ununterscheidbar.
    .do = Eine davon abdecken oder eine zweite mit anderen Punktzahlen nehmen.

target_seen-points = { $photographs } { $photographs ->
        [one] Aufnahme
        *[other] Aufnahmen
    }, { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } von { $target }.

target_seen-observations = Bildbeobachtungen: { $named } mit Namen, { $unnamed } ohne.

target_seen-photograph = { $name }: { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    }: { $points }
