block-merged = Zusammengefügt: { $images } Bilder, { $points } Punkte, { $observations } Bildbeobachtungen (Rahmen von { $name }).

block-adjust_merged = raybundle adjust { $block } { OPTION("reject", "snooping") } { OPTION("out", "ERGEBNIS") }

block-converted = Umgewandelt ({ $formats }): { $images } orientierte Bilder, { $points } Punkte, { $observations } Bildbeobachtungen.

block-cameras_fitted = Kameras sind angepasst: größte Abweichung { $largest_px } px.

block-more_files = { $n } { $n ->
        [one] weitere Datei liegt
        *[other] weitere Dateien liegen
    } daneben.

block-simulated = Simuliert: { $images } Bilder, { $points } Objektpunkte, { $observations } Bildbeobachtungen, { $blunders } grobe { $blunders ->
        [one] Fehler
        *[other] Fehler
    }.

block-transformed = Transformiert: Ursprung { $origin }, X-Achse durch { $axis }.
