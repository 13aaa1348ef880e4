marked_once = { $n } { $n ->
     [one] Punkt ist
     *[other] Punkte sind
    } nur in einer Aufnahme gemessen und nicht bestimmt: { $ids }.
    .do = Diese Punkte in einer zweiten Aufnahme messen.
