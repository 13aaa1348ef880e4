report_network-title = Netz

report_network-precision_title = Präzision der Objektpunkte

report_network-no_statistics = Standardabweichungen wurden nicht berechnet (die Statistik ist abgeschaltet).

report_network-all_held = Alle Objektpunkte sind festgehalten: Sie haben keine Standardabweichungen.

report_network-weakest_list = Die schwächsten Punkte

report_network-weakest = Punkte mit den größten Standardabweichungen

report_network-deviations = Standardabweichungen von { $axis }; die letzte Säule enthält alle größeren.

report_network-views = Grundriss (XY), darunter Vorderansicht (XZ), daneben Seitenansicht (ZY).

report_network-drawn = Gezeichnet: { $points } von { $of } Punkten, { $images } von { $of_images } Bildern.

report_network-far_points = { $n } { $n ->
        [one] ferner Punkt liegt
        *[other] ferne Punkte liegen
    } außerhalb des Rahmens.

report_network-ellipses = Fehlerellipsen (1 σ, Wahrscheinlichkeit 39 %) von { $n } { $n ->
        [one] Punkt
        *[other] Punkten
    }, { $factor }-fach vergrößert.

report_network-symbols = Dreiecke: Passpunkte; Kreise: Kontrollpunkte.

report_network-arbitrary_system = Das Koordinatensystem ist beliebig.

report_network-geometry_not_computed = Winkel, Basis-Tiefen-Verhältnisse und Abdeckung wurden nicht berechnet (die Statistik ist abgeschaltet).

report_network-rays = Strahlen je Punkt (kleinster … Median … größter Wert)

report_network-mean_rays = Mittel { NUM($mean, decimals: 2) }

report_network-stations = Standpunkte je Punkt

report_network-stations_meaning = Strahlen von verschiedenen Projektionszentren

report_network-largest_angle = größter Schnittwinkel

report_network-small_angles = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } unter 5°

report_network-distance = Abstand zum Objekt

report_network-distance_meaning = Median jedes Bildes

report_network-image_scale = Bildmaßstabszahl S

report_network-image_scale_meaning = Abstand durch Kammerkonstante

report_network-base_to_depth = Basis-Tiefen-Verhältnis

report_network-pairs_with_points = { $n } { $n ->
        [one] Paar
        *[other] Paare
    } mit { $least } gemeinsamen Punkten oder mehr

report_network-coverage = Abdeckung des Formats

report_network-coverage_meaning = Anteil der 10 × 10 Zellen mit einem Punkt

report_network-parts = zusammenhängende Teile

report_network-q_meaning = σ = q S σ(xy) / √k, k: mittlere Zahl der Strahlen je Punkt

report_network-q_stations = q nach Standpunkten

report_network-q_stations_meaning = ebenso mit der mittleren Zahl der Standpunkte

report_network-efficiency = Wirkungsgrad der Richtungen

report_network-efficiency_meaning = (Schranke / q)², Schranke { $bound } für Strahlen aus allen Richtungen

report_network-ray_histogram = Strahlen je Objektpunkt.

report_network-angle_histogram = Größter Schnittwinkel jedes Punktes.

report_network-scale_histogram = Bildmaßstabszahlen; die größte ist das { NUM($ratio, digits: 2) }-Fache der kleinsten.

report_network-ratio_histogram = Basis-Tiefen-Verhältnis von { $n } { $n ->
        [one] Bildpaar
        *[other] Bildpaaren
    }; die letzte Säule enthält alle über { $most }.

report_network-roll = Kantung um die Aufnahmeachse, die häufigste oben; { $n } { $n ->
        [one] Bild
        *[other] Bilder
    } nahe ±90°.

report_network-not_rolled = Ohne gekantete Bilder bleiben Hauptpunkt und tangentiale Verzeichnung korreliert.

report_network-no_pairs = Keine zwei Bilder haben { $least } gemeinsame Punkte oder mehr.

report_network-pairs_shown = { $n } von { $of } Paaren sind gezeigt.

report_network-pairs_order = Paare nach der Zahl ihrer gemeinsamen Punkte.

report_network-pairs_chosen = { $n } von { $of } Paaren, gleichmäßig ausgewählt vom stärksten bis zum schwächsten.

report_network-image_pairs = { $n } { $n ->
        [one] Bildpaar
        *[other] Bildpaare
    }

report_network-coverage_of_images = Abdeckung des Formats durch Bildpunkte, jedes Bild.
