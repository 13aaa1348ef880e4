small_angle = { $n } { $n ->
        [one] Objektpunkt ist
       *[other] Objektpunkte sind
     } unter weniger als { $limit_deg }° geschnitten: { $ids }.
    .why = Ihre Tiefe ist schwach bestimmt.
