control_not_observed = { $n } { $n ->
        [one] Passpunkt ist
       *[other] Passpunkte sind
     } in keinem Bild gemessen und { $n ->
        [one] geht
       *[other] gehen
     } nicht in die Ausgleichung ein: { $ids }.
    .do = Diese Passpunkte in den Bildern messen oder die Namen korrigieren. `raybundle mark find PROJEKT` findet Signale am Boden.

control_not_observed-rejected = { $n } { $n ->
        [one] Passpunkt geht
       *[other] Passpunkte gehen
     } nicht in die Ausgleichung ein: Alle Bildmessungen wurden verworfen ({ $ids }).
    .do = Koordinaten, Namen und Bildmessungen prüfen.
