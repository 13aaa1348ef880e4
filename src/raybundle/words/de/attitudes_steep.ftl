attitudes_steep = { $n } { $n ->
     [one] Lage wird
     *[other] Lagen werden
    } nicht verwendet: { $ids }.
    .why = Diese Aufnahmen blicken entlang der X-Achse, wo omega und kappa um dieselbe Achse drehen.
