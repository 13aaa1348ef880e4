behind_camera = { $n } { $n ->
        [one] Bildpunkt liegt
       *[other] Bildpunkte liegen
     } hinter der Kamera und { $n ->
        [one] geht
       *[other] gehen
     } nicht in die Ausgleichung ein: { $pairs }.
    .do = Die Punktnummern prüfen.

behind_camera-photographs = { $n } { $n ->
        [one] Aufnahme hat
       *[other] Aufnahmen haben
     } mehr als { PERCENT($limit) } % der Verknüpfungspunkte hinter der Kamera: { $ids }.
    .why = Diese Aufnahmen können auf der falschen Seite des Objekts orientiert sein.
    .do = Die Positionen dieser Aufnahmen mit den wirklichen Standpunkten vergleichen.

behind_camera-matches = { $n } falsche { $n ->
        [one] Zuordnung hinter der Kamera geht
       *[other] Zuordnungen hinter der Kamera gehen
     } nicht in die Ausgleichung ein: { $pairs }.
    .why = Das Ergebnis enthält diese Zuordnungen nicht.
    .do = Bei vielen falschen Zuordnungen die Aufnahmen auf sich wiederholende Strukturen prüfen.
