marks_left_out = { $n } gemessene { $n ->
        [one] Punkt ist
       *[other] Punkte sind
    } nicht in der Ausgleichung: { $names }.
    .why = Ein Punkt braucht Messungen in zwei orientierten Fotos.
    .do = Die Punkte in weiteren Fotos messen.
