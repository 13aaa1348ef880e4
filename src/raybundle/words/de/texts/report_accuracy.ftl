report_accuracy-title = Genauigkeit: Grundlage jeder Kenngröße

report_accuracy-object_note = Standardabweichungen enthalten zufällige Fehler, Differenzen an Kontrollpunkten alle Fehler.

report_accuracy-all_points = Objektpunkte sind überall die mit einer freien Koordinate und einem verwendeten Strahl.

report_accuracy-in_object_space = Im Objektraum

report_accuracy-in_images = In den Bildern

report_accuracy-image_note = Angesetzt mal σ₀ ist die Präzision einer Messung; ihre Verbesserung ist um den Anteil 1 − r kleiner.
    .why = Die Ausgleichung nimmt diesen Anteil jedes Fehlers auf (r: mittlerer Redundanzanteil).

report_accuracy-over = Grundlage

report_accuracy-noise_column = Rauschen

report_accuracy-noise = { $noise ->
        [white] unabhängige Fehler
        [fields] unabhängige und glatte Fehler
        *[none] keines: Differenzen
    }

report_accuracy-points = { $n } { $kind ->
        [object] { $n ->
            [one] Objektpunkt
            *[other] Objektpunkte
        }
        [check] { $n ->
            [one] Kontrollpunkt
            *[other] Kontrollpunkte
        }
        *[control] { $n ->
            [one] Passpunkt
            *[other] Passpunkte
        }
    }, { $coordinates } { $coordinates ->
        [one] Koordinate
        *[other] Koordinaten
    }

report_accuracy-check_points = { $n } { $n ->
        [one] Kontrollpunkt
        *[other] Kontrollpunkte
    }

report_accuracy-lengths = { $n } { $n ->
        [one] Strecke
        *[other] Strecken
    }

report_accuracy-image_observations = { $n } verwendete { $n ->
        [one] Bildbeobachtung
        *[other] Bildbeobachtungen
    }, { $coordinates } Koordinaten

report_accuracy-deviation = Standardabweichung, { $kind ->
        [rms] RMS
        [mean] Mittel
        *[median] Median
    }

report_accuracy-deviation_rms = einer Koordinate; durch wenige schwache Punkte vergrößert

report_accuracy-deviation_mean = einer Koordinate{ $omitted ->
        [0] {""}
        *[other] , ohne die { PERCENT($omitted) } % ungenauesten Punkte
    }{ $related ->
        [yes] ; die von 1 : N
        *[no] {""}
    }

report_accuracy-deviation_median = die Hälfte der Koordinaten ist genauer

report_accuracy-relative = relative Präzision

report_accuracy-relative_meaning = mittlere Standardabweichung durch die größte Ausdehnung, { $extent } { $unit ->
        [units] Einheiten
        *[other] { $unit }
    }
    .why = Ausdehnung: Diagonale des Quaders entlang der Hauptachsen{ $cut ->
            [yes] , ohne die äußersten 0,25 % an jedem Ende einer Achse
            *[no] {""}
        }

report_accuracy-check = Differenz an Kontrollpunkten, RMS

report_accuracy-check_meaning = ausgeglichen minus gegeben; enthält Fehler der gegebenen Koordinaten und die allen Aufnahmen gemeinsamen

report_accuracy-expected = erwartet

report_accuracy-check_expected = Standardabweichung von ausgeglichener und gegebener Koordinate zusammen, an diesen Punkten

report_accuracy-length_error = Längenmessabweichung, RMS

report_accuracy-length_meaning = gemessen minus bekannt, an unabhängigen Strecken; enthält die Fehler ihrer Kalibrierscheine

report_accuracy-length_expected = Standardabweichung von gemessener und bekannter Strecke zusammen

report_accuracy-asprs = { $plan ->
        [yes] beide Achsen der Lage zusammen
        *[no] Höhe
    }: Differenz an Kontrollpunkten, mit deren angegebenem Fehler

report_accuracy-points_left_out = Kreuzvalidierung, Passpunkte, RMS

report_accuracy-points_meaning = ausgeglichen minus gegeben, wenn der ganze Punkt nicht teilgenommen hätte, in erster Ordnung

report_accuracy-coordinates_left_out = Kreuzvalidierung, Passpunktkoordinaten, RMS

report_accuracy-coordinates_meaning = ebenso je Koordinate, mit den anderen ihres Punktes

report_accuracy-image_coordinate = Bildkoordinate

report_accuracy-no_image_point = kein Bildpunkt

report_accuracy-not_measured = keine Messung in Bildern

report_accuracy-stated = angesetzt{ $kind ->
        [one] {""}
        [median] , Median
        *[rms] , RMS
    }

report_accuracy-stated_meaning = Standardabweichung a priori jeder Beobachtung (ihr Gewicht)

report_accuracy-stated_rms = weniger genaue Punkte zählen mehr

report_accuracy-scaled = angesetzt mal σ₀{ $kind ->
        [one] {""}
        [median] , Median
        *[rms] , RMS
    }

report_accuracy-by_sigma0 = aus den Verbesserungen: σ₀ = { $sigma0 }{ $kind ->
        [rms] ; die eines gemessenen Bildpunktes
        *[median] {""}
    }

report_accuracy-residual = Verbesserung, RMS

report_accuracy-residual_meaning = ausgeglichen minus gemessen{ $known ->
        [yes] , mittlerer Redundanzanteil { NUM($r, digits: 2) }
        *[no] {""}
    }
