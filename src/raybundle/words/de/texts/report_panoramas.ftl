report_panoramas-title = Panoramen

report_panoramas-camera = Kamera { $camera }

report_panoramas-count = { $n } { $n ->
        [one] Panorama
        *[other] Panoramen
    } mit { $points } Bildpunkten.

report_panoramas-extent = Richtung { NUM($direction_from, decimals: 0) }° bis { NUM($direction_to, decimals: 0) }°, Höhenwinkel { NUM($elevation_from, decimals: 0) }° bis { NUM($elevation_to, decimals: 0) }°.

report_panoramas-rms = Verbesserungen (RMS): { $arc_px } px entlang des Bogens, { $line_px } px entlang der Zeile.

report_panoramas-residuals = Verbesserungen

report_panoramas-no_trend = Keine mittlere Verbesserung ändert sich signifikant mit Richtung oder Höhenwinkel.

report_panoramas-sketch = Ansicht von oben. Balken: Bildpunkte nach Richtung.
    .why = Mitte: Drehachse (Kreuz) und Projektionszentrum für eine Blickrichtung nach oben, vergrößert, mit seinen Standardabweichungen.

report_panoramas-chance = Wahrscheinlichkeit durch Zufall: { P($p) }.

report_panoramas-against = Verbesserungen entlang { $arc ->
        [yes] des Bogens
        *[no] der Zeile
    } gegen { $angle ->
        [direction] Richtung
        *[elevation] Höhenwinkel
    }, gleitendes Mittel; Band: 95 % ohne Trend.

report_panoramas-trend = Die mittlere Verbesserung entlang { $arc ->
        [yes] des Bogens
        *[no] der Zeile
    } ändert sich mit { $angle ->
        [direction] der Richtung
        *[elevation] dem Höhenwinkel
    }, um bis zu { NUM($size_px, digits: 2) } px.
    .why = Mögliche Ursachen: Exzentrizität, Neigung der Zeile, taumelnde Achse, Refraktion.

report_panoramas-angle = { $angle ->
        [direction] Richtung
        *[elevation] Höhenwinkel
    }

report_panoramas-eccentricity = Exzentrizität

report_panoramas-eccentric = Das Projektionszentrum liegt neben der Drehachse.

report_panoramas-offset = { $symbol ->
        [e] In
        *[d] Quer zur
    } Blickrichtung: { NUM($value, digits: 5) } ± { NUM($sigma, digits: 2) } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }.
