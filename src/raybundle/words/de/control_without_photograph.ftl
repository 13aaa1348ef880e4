control_without_photograph = { $n } { $n ->
     [one] Messung
     *[other] Messungen
    } aus { $table } { $n ->
     [one] ist
     *[other] sind
    } in Aufnahmen, die fehlen: { LIST($names, most: 5) }.
    .do = Diese Aufnahmen ergänzen oder ihre Namen korrigieren.
