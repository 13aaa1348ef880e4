one_ray_control = { $n } { $n ->
        [one] Passpunkt hat
       *[other] Passpunkte haben
     } nur einen Strahl: { $ids }.
    .do = Jeden Passpunkt in mindestens zwei Aufnahmen messen.
