small_angle = { $n } { $n ->
        [one] Objektpunkt ist
       *[other] Objektpunkte sind
     } unter weniger als { $limit_deg }° geschnitten: { $ids }.
    .why = Die Tiefe dieser Punkte ist schwach bestimmt; ihre Standardabweichungen enthalten das.
    .do = Wird die Tiefe dieser Punkte gebraucht, sie von einem seitlichen Standpunkt aufnehmen.
