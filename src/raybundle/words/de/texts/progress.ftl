progress-stage = { $stage ->
        [adding_stations] Standpunkte ergänzen
        [adjusting] Ausgleichung
        [adjustment] Ausgleichung
        [cameras] Kameras
        [candidates] Kandidaten
        [choosing_pairs] Bildpaare wählen
        [cleaning] Bereinigung
        [colours] Farben
        [comparing] Vergleich
        [control] Passpunkte
        [correcting] Korrektur
        [depth_maps] Tiefenkarten
        [drawing] Zeichnen
        [exchanging_stations] Standpunkte tauschen
        [features] Merkmale
        [fetching] Herunterladen
        [fitting_parts_to_each_other] Teile aneinanderpassen
        [fusion] Fusion
        [heights] Höhen
        [least_squares_matching] Kleinste-Quadrate-Zuordnung
        [looking_at_the_frames] Einzelbilder prüfen
        [maps_against_each_other] Tiefenkarten vergleichen
        [matching] Zuordnung
        [measuring] Messen
        [moving_stations] Standpunkte verschieben
        [moving_stations_together] Standpunkte gemeinsam verschieben
        [orienting] Orientierung
        [orienting_all_images_at_once] Gemeinsame Orientierung aller Bilder
        [orthophoto] Orthophoto
        [orthorectifying] Orthorektifizierung
        [photographs] Fotos
        [photographs_of_the_region] Fotos des Gebiets
        [photographs_on_heights] Fotos auf Höhen
        [picture] Bild
        [pixels_of_the_orthophoto] Pixel des Orthophotos
        [places_in_the_photographs] Orte in den Fotos
        [points_above_the_grid] Punkte über dem Gitter
        [precision] Genauigkeit
        [precision_over_drawings] Genauigkeit über Zufallsziehungen
        [proposals] Vorschläge
        [reading] Lesen
        [reading_blocks] Blöcke lesen
        [reading_measurements] Messungen lesen
        [reading_photographs] Fotos lesen
        [reading_results] Ergebnisse lesen
        [reading_tables] Tabellen lesen
        [rectifying] Entzerrung
        [report] Bericht
        [report_printed_pages] Bericht: gedruckte Seiten
        [standard_deviations_of_depths] Standardabweichungen der Tiefen
        [start] Näherungswerte
        [statistics] Statistik
        [steps_between_heights] Stufen zwischen Höhen
        [targets] Zielmarken
        [testing] Prüfung
        [testing_common_points] Gemeinsame Punkte prüfen
        [tracks] Punktverfolgung
        [undistorting] Verzeichnung entfernen
        [weights] Gewichte
        [what_photographs_see] Sichtbarkeit in den Fotos
        [what_was_photographed] Aufnahmen erkennen
        [writing] Schreiben
        [writing_frames] Einzelbilder schreiben
        [writing_tables] Tabellen schreiben
        *[other] { $name }
    }

progress-line = { $stage }: { PERCENT($share) } %{ $left ->
        [0] {""}
       *[other] , noch { NUM($left, digits: 2) } min
    }
