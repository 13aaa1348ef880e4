check_unseen = { $n } { $n ->
        [one] Kontrollpunkt hat
       *[other] Kontrollpunkte haben
     } weniger als zwei Strahlen und { $n ->
        [one] wird
       *[other] werden
     } nicht verglichen: { $ids }.
    .do = Jeden Kontrollpunkt in mindestens zwei Aufnahmen messen.

check_unseen-no_measurement = { $n } { $n ->
     [one] Kontrollpunkt hat
     *[other] Kontrollpunkte haben
    } keine verwendbare Bildmessung: { $ids }.
    .do = Jeden Kontrollpunkt in mindestens zwei Aufnahmen messen.
