marked_lost = Der markierte Punkt { $point } fehlt im Ergebnis: Seine { $rays } Strahlen sind parallel oder schneiden sich nicht.
    .do = Seine Markierungen prüfen und ihn in Aufnahmen von anderen Orten markieren.
