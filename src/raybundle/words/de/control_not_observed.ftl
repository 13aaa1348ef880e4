control_not_observed = { $n } { $n ->
        [one] Passpunkt ist
       *[other] Passpunkte sind
     } in keinem Bild gemessen und { $n ->
        [one] nimmt
       *[other] nehmen
     } nicht teil: { $ids }.
    .do = Sie in den Bildern messen oder die Namen berichtigen.

control_not_observed-rejected = { $n } { $n ->
        [one] Passpunkt nimmt
       *[other] Passpunkte nehmen
     } nicht teil: Alle Bildpunkte wurden verworfen ({ $ids }).
    .do = Koordinaten, Namen und Marken prüfen.
