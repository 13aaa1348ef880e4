distance_lost = { $n } { $n ->
        [one] Strecke geht
       *[other] Strecken gehen
     } nicht in die Ausgleichung ein: Bildmessungen der Enden wurden verworfen ({ $ids }).
    .do = Die Bildmessungen dieser Punkte prüfen.
