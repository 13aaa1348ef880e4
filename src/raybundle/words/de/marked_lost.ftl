marked_lost = Der gemessene Punkt { $point } fehlt im Ergebnis: Seine { $rays } Strahlen sind parallel oder schneiden sich nicht.
    .do = Seine Bildmessungen prüfen und ihn in Aufnahmen von anderen Standpunkten messen.
