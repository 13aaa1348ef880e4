joint-no_covariances = Die Ausgleichung hat keine Kovarianzen.
    .why = Die Ausgleichung wurde ohne Statistik berechnet oder ist eine Kopie.
    .do = Erneut mit Statistik ausgleichen.

joint-image_not_used = Bild { $image } ist nicht in der Ausgleichung.
    .do = Ein beteiligtes Bild wählen oder in diesem Bild mehr Punkte messen und neu ausgleichen.

joint-point_not_used = Punkt { $point } ist nicht in der Ausgleichung.
    .do = Einen beteiligten Punkt wählen oder diesen Punkt in mehr Bildern messen und neu ausgleichen.

joint-no_named_points = { $name }: Kein ausgeglichener Punkt hat einen eigenen Namen.
    .do = Zielmarken messen oder Punkte markieren.

joint-too_many_points = { $name }: { $n } Punkte; eine gemeinsame Kovarianz ist für { $most } möglich.
    .do = Einige der Punkte nennen.

joint-unknown_point = Punkt { $point } ist nicht im Ergebnis.
    .why = Das Ergebnis hat { $known }.
    .do = Den Namen korrigieren.
