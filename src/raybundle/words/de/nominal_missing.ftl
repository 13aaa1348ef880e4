nominal_missing = { $n } { $n ->
        [one] Sollpunkt wurde
       *[other] Sollpunkte wurden
     } nicht gemessen: { LIST($ids, most: 10) }.
    .why = Abweichungen dieser Punkte sind unbekannt; die Einpassung beruht auf den übrigen Punkten.
    .do = Diese Punkte messen oder aus den Sollkoordinaten löschen.
