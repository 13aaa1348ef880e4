relative_control = Positionen von { $photographs } Aufnahmen auf { $lines } Flugstreifen werden über ihre Differenzen verwendet{ $drift ->
        [yes] {" "}(mit Drift)
       *[no] {""}
    }.
    .why = Ein konstanter Fehler der Positionen eines Streifens verformt den Block dann nicht.
    .do = Für die absolute Lage mindestens drei Passpunkte angeben.

relative_control-excluded = { $n } { $n ->
        [one] Aufnahme
       *[other] Aufnahmen
    } auf keinem Flugstreifen { $n ->
        [one] ist
       *[other] sind
    } ausgeschlossen.

relative_control-open = Ohne Passpunkte in { $axes } gilt die Verschiebung eines Streifens als auf { $plan_m } m in der Lage, { $height_m } m in der Höhe bekannt.
