control_unchecked = { $n } { $n ->
        [one] Passpunkt ist
       *[other] Passpunkte sind
     } durch die übrigen Beobachtungen nicht kontrolliert: { $ids }.
    .why = Ein Fehler dort verfälscht das Ergebnis unbemerkt.
    .do = Passpunkte oder Kontrollpunkte ergänzen.

control_unchecked-axis = { $axis } von { $points }: Ein Fehler unter { NUM($least, digits: 2) } { $unit } bei { $point } bliebe unbemerkt.

control_unchecked-no_limit = { $axis } von { $points }: Auch ein beliebig großer Fehler bliebe unbemerkt.
