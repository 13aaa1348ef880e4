label-accuracy = Genauigkeit

label-adjusted = Ausgeglichen

label-adjusted_minus_given = ausgeglichen minus gegeben

label-block = Bildverband

label-blunders = Grobe Fehler

label-camera = Kamera

label-cameras = Kameras

label-check_points = Kontrollpunkte

label-control = Passpunkte

label-coordinate = Koordinate

label-correlation = Korrelation

label-cross_validation = Kreuzvalidierung

label-datum = Datum

label-fit = Anpassung

label-format = Format

label-given = gegeben

label-image_observations = Bildbeobachtungen

label-image_points = Bildpunkte

label-images = Bilder

label-known_lengths = Bekannte Längen

label-leave_one_out = Kreuzvalidierung

label-length = Länge

label-object_points = Objektpunkte

label-observations = Beobachtungen

label-parameter = Parameter

label-photographs = Aufnahmen

label-point = Punkt

label-point_standard_deviation = Standardabweichung der Objektpunkte

label-precision = Präzision

label-projection_uncertainty = Unsicherheit der Abbildung

label-quantity = Größe

label-redundancy = Redundanz

label-relative_precision = relative Präzision

label-role = Rolle

label-standard_deviation = Standardabweichung

label-unknowns = Unbekannte

label-value = Wert
