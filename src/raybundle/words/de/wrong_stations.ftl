wrong_stations = { $n } { $n ->
        [one] Standpunkt ist
       *[other] Standpunkte sind
    } mit einer Wahrscheinlichkeit über { PERCENT($limit) } % falsch: { LIST($ids, most: 4) }.
    .why = Die größte Wahrscheinlichkeit ist { PERCENT($largest) } %. Falsch: um mehr als 1 % der Ausdehnung oder 1°. So genannt werden auch { PERCENT($false_alarms) } % der richtigen Standpunkte.
    .do = Diese Aufnahmen ansehen; überlappende Aufnahmen ergänzen oder sie weglassen.
