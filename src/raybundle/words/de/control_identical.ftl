control_identical = { $pairs } { $pairs ->
        [one] Passpunktpaar
       *[other] Passpunktpaare
     } mit gleichen Koordinaten { $pairs ->
        [one] besteht
       *[other] bestehen
     } aus verschiedenen Punkten: { $ids }.
    .why = Vielleicht wurde eine Zeile der Datei kopiert.
    .do = Jedem Punkt eigene Koordinaten geben oder ihn weglassen.

control_identical-alike = { $pairs } { $pairs ->
        [one] Passpunktpaar hat
       *[other] Passpunktpaare haben
     } innerhalb der Standardabweichung gleiche Koordinaten: { $ids }.
    .why = Die Standardabweichungen trennen diese Punkte nicht.
    .do = Einem einzigen Punkt einen einzigen Namen geben oder die Standardabweichungen korrigieren.

control_identical-pair = Ein Paar sind { $first } und { $second }.

control_identical-pair_apart = Ein Paar sind { $first } und { $second }: { NUM($apart_px, decimals: 0) } px Abstand im Bild { $image }.
