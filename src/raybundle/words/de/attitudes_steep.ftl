attitudes_steep = { $n } { $n ->
     [one] Satz Lagewinkel wird
     *[other] Sätze Lagewinkel werden
    } nicht verwendet: { $ids }.
    .why = Diese Aufnahmen blicken entlang der X-Achse, wo omega und kappa um dieselbe Achse drehen.
