report_tables-title = Koordinaten und Orientierungen

report_tables-object_points = { $n } { $n ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }

report_tables-images = { $n } { $n ->
        [one] Bild
        *[other] Bilder
    }

report_tables-points_printed = { $n } von { $of } Punkten: bekannte und benannte, die mit den größten Standardabweichungen, eine Stichprobe.

report_tables-all_points = Alle Punkte stehen in points.csv, mit { OPTION("all_coordinates", "True") } auch hier.

report_tables-first_points = Die ersten { $n } von { $of } Punkten.

report_tables-changed = geändert

report_tables-input_label = Eingabe

report_tables-hash = SHA-256 der Werte

report_tables-software_label = Software

report_tables-settings = Einstellungen

report_tables-input = Eingabe

report_tables-about = { $kind ->
        [description] Beschreibung
        [source] Quelle
        *[licence] Lizenz
    }: { $text }

report_tables-software = Software

report_tables-provenance = Einstellungen, Eingabe und Software

report_tables-table = { $name ->
        [cameras] Kameras
        [images] Bilder
        [observations] Beobachtungen
        [points] Punkte
        [instruments] Antennen und IMU
        [rig_stations] Stationen der Rigs
        [distances] Strecken
        [stations] Projektionszentren
        [attitudes] Drehungen
        [planes] Ebenen
        [lines] Linien
        [plumb_lines] Lotlinien
        [levels] Höhengleiche
        [coordinates] Koordinaten
        [deviations] Abweichungen
        [directions] Richtungen
        [zenith_angles] Zenitwinkel
        [slope_distances] Schrägstrecken
        [differences] Koordinatendifferenzen
        *[other] { $other }
    }

report_tables-kernel = { $native ->
        [yes] nativer Rechenkern, auch für RootSIFT
        *[no] NumPy (ohne nativen Rechenkern: langsamer, gleiche Ergebnisse aus gleichen Bildpunkten), RootSIFT von OpenCV
    }

report_tables-not_installed = nicht installiert
