label-rows_shown = { $n } von { $of } Zeilen sind gezeigt.

label-rows_shown_of = { $n } von { $of } Zeilen sind gezeigt; alle stehen in { $rest }.

label-quantity = Größe

label-value = Wert

label-camera = Kamera

label-symbol = Symbol

label-unit = Einheit

label-sigma = σ

label-ratio = Verhältnis

label-rows_chosen = { $n } von { $of } Zeilen, gleichmäßig ausgewählt; alle stehen in { $rest }.

label-image = Bild

label-point = Punkt

label-axis = Achse

label-rays = Strahlen

label-reason = Grund

label-largest_w = größtes |w|

label-test = Test

label-level = Niveau

label-source = Quelle

label-mdb_note = MDB: kleinster aufdeckbarer grober Fehler.

label-file = Datei

label-points = Punkte

label-rejected = verworfen

label-sigma_ratio = σ a posteriori / a priori

label-coordinate = Koordinate

label-mean = Mittel

label-smallest = kleinster Wert

label-median = Median

label-largest = größter Wert

label-at_point = an Punkt

label-intersection_angle = Schnittwinkel

label-sigma_of = σ { $symbol }

label-figure = Kenngröße

label-meaning = Bedeutung

label-common_points = gemeinsame Punkte

label-status = Status

label-share = Anteil

label-given = gegeben

label-adjusted = ausgeglichen

label-residual = Verbesserung

label-held = festgehalten

label-observations = Beobachtungen

label-group = Gruppe

label-number = Anzahl

label-redundancy = Redundanz

label-n_of = { $n } von { $of }

label-cameras = Kameras

label-object_points = Objektpunkte

label-image_points = Bildpunkte

label-photograph = Aufnahme

label-photographs = Aufnahmen

label-remedy = Abhilfe

label-pairs = Paare

label-name = Name

label-time = Zeit

label-result = Ergebnis

label-setting = Einstellung

label-observed = beobachtet

label-stated_sigma = σ, angegeben

label-model = Modell

label-parameter = Parameter

label-count_of_points = { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    }

label-length = Länge

label-yes = ja

label-from = von

label-to = nach

label-measured = gemessen

label-error = Abweichung

label-allowed = zulässig

label-role = Rolle

label-role_of = { $role ->
        [control] Passpunkt
        [check] Kontrollpunkt
        [tie] Verknüpfungspunkt
        *[other] { $role }
    }

label-angle = Winkel

label-rows = Zeilen

label-version = Version
