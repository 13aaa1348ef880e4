errors_independent = Mit { $images } Aufnahmen gelten Fehler der Bildpunkte als unabhängig (sonst sind { $least } nötig).
    .why = In neun wirklichen Datensätzen waren solche Standardabweichungen für innere Orientierungen { $interior_least }- bis { $interior_most }-mal zu klein, für Objektpunkte { $points_least }- bis { $points_most }-mal.
    .do = { $least } oder mehr Aufnahmen machen oder mit Kontrollpunkten oder bekannten Strecken vergleichen.
