label-accuracy = Genauigkeit

label-adjusted = ausgeglichen

label-adjusted_minus_given = ausgeglichen minus gegeben

label-allowed = zulässig

label-angle = Winkel

label-at_point = an Punkt

label-axis = Achse

label-block = Bildverband

label-blunders = Grobe Fehler

label-camera = Kamera

label-cameras = Kameras

label-check_points = Kontrollpunkte

label-common_points = gemeinsame Punkte

label-control = Passpunkte

label-coordinate = Koordinate

label-correlation = Korrelation

label-count_of_points = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    }

label-cross_validation = Kreuzvalidierung

label-datum = Datum

label-error = Abweichung

label-figure = Kenngröße

label-file = Datei

label-fit = Anpassung

label-format = Format

label-free_unit = Einheiten

label-from = von

label-given = gegeben

label-group = Gruppe

label-heading_adjusted = Ausgeglichen

label-heading_cameras = Kameras

label-held = festgehalten

label-image = Bild

label-image_observations = Bildbeobachtungen

label-image_points = Bildpunkte

label-images = Bilder

label-in_free_units = { NUM($value) } Einheiten

label-intersection_angle = Schnittwinkel

label-known_lengths = Bekannte Längen

label-largest = größter Wert

label-largest_w = größtes |w|

label-leave_one_out = Kreuzvalidierung

label-length = Länge

label-level = Niveau

label-mdb_note = MDB: kleinster aufdeckbarer grober Fehler.

label-mean = Mittel

label-meaning = Bedeutung

label-measured = gemessen

label-median = Median

label-model = Modell

label-n_of = { $n } von { $of }

label-name = Name

label-number = Anzahl

label-object_points = Objektpunkte

label-observations = Beobachtungen

label-observed = beobachtet

label-pairs = Paare

label-parameter = Parameter

label-photograph = Aufnahme

label-photographs = Aufnahmen

label-point = Punkt

label-point_standard_deviation = Standardabweichung der Objektpunkte

label-points = Punkte

label-precision = Präzision

label-projection_uncertainty = Unsicherheit der Abbildung

label-quantity = Größe

label-ratio = Verhältnis

label-rays = Strahlen

label-reason = Grund

label-redundancy = Redundanz

label-rejected = verworfen

label-relative_precision = relative Präzision

label-remedy = Abhilfe

label-residual = Verbesserung

label-result = Ergebnis

label-role = Rolle

label-role_of = { $role ->
        [control] Passpunkt
        [check] Kontrollpunkt
        [tie] Verknüpfungspunkt
        *[other] { $role }
    }

label-rows = Zeilen

label-rows_chosen = { $n } von { $of } Zeilen, gleichmäßig ausgewählt; alle stehen in { $rest }.

label-rows_shown = { $n } von { $of } Zeilen sind gezeigt.

label-rows_shown_of = { $n } von { $of } Zeilen sind gezeigt; alle stehen in { $rest }.

label-setting = Einstellung

label-share = Anteil

label-sigma = σ

label-sigma_of = σ { $symbol }

label-sigma_ratio = σ a posteriori / a priori

label-smallest = kleinster Wert

label-source = Quelle

label-standard_deviation = Standardabweichung

label-stated_sigma = σ, angegeben

label-status = Status

label-symbol = Symbol

label-test = Test

label-time = Zeit

label-to = nach

label-truth = { $value ->
        [yes] ja
        *[no] nein
    }

label-unit = Einheit

label-unknowns = Unbekannte

label-value = Wert

label-version = Version

label-yes = ja

label-rms = RMS

label-rms_of = RMS { $of }
