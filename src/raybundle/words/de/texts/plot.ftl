plot-cell_means = Kamera { $camera }: Mittel der Zellen

plot-none_of_camera = kein Bildpunkt der Kamera { $camera } hat einen

plot-mean_and_smallest = Mittel { NUM($mean, decimals: 3) } (Linie), kleinster { NUM($smallest, decimals: 3) }

plot-median_and_largest = Median { NUM($median_px, digits: 2) } px (Linie), größter { NUM($largest_px, digits: 2) } px

plot-not_counted = { $n } mit r unter { $limit } nicht gezählt

plot-residuals = Kamera { $camera }: { $n } von { $of } Verbesserungen

plot-means_from_zero = Mittel der Zellen; { $of ->
        [0] zu wenige Punkte
        *[other] { $n } von { $of } weichen von null ab (fett)
    }

plot-no_sigma = keine Verbesserung hat eine Standardabweichung

plot-coordinates = { $n } Koordinaten

plot-normal = Normalverteilung

plot-beyond = RMS { NUM($rms, decimals: 2) }; { $n } jenseits ±3,29 ({ NUM($expected, digits: 2) } erwartet)

plot-radial = radiale Korrektion, ideal − gemessen

plot-decentring = tangentiale Verzeichnung, größte aller Richtungen

plot-decentring_curve = tangential

plot-correction_sigma = Standardabweichung der Korrektionen

plot-corrections = Korrektionen, { $times ->
        [1] wahre Größe
        *[other] { $times }-fach
    }; größte { NUM($largest_px) } px

plot-projection = Unsicherheit der Abbildung bei { $distance ->
        [0] unendlich
        *[other] { NUM($distance, digits: 2) } { $unit ->
            [units] Einheiten
            *[other] { $unit }
        }
    }; größte { NUM($largest_px, digits: 2) } px

plot-network = { $images } { $images ->
        [one] Bild
        *[other] Bilder
    }, { $points } { $points ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }{ $far ->
        [0] {""}
        *[other] {" "}({ $far } ferne außerhalb)
    }

plot-ellipses = Fehlerellipsen von { $n } Punkten, einfache Standardabweichung, { NUM($times, digits: 6) }-fach vergrößert

plot-error_ellipses = Fehlerellipsen

plot-differences_in_plan = Abweichungen im Grundriss

plot-in_order_of_names = Punkte in der Reihenfolge ihrer Namen
