axis-across = quer [{ $unit }]

axis-along = { $arc ->
        [yes] längs des Bogens
        *[no] längs der Zeile
    } [px]

axis-along_object = längs des Objekts [{ $unit }]

axis-base_to_depth = Basisverhältnis

axis-correction = Korrektion [{ $unit }]

axis-coverage = Ausnutzung [%]

axis-distance = Abstand [px]

axis-distance_from_middle = Abstand von der Mitte / halbe Diagonale

axis-error = Abweichung [mm]

axis-expected_quantile = erwartetes Quantil

axis-height = Höhe

axis-height_in = Höhe [{ $unit }]

axis-image_scale = Bildmaßstabszahl

axis-images_in_order = Bild, in der Reihenfolge des Bildverbands

axis-largest_intersection_angle = größter Schnittwinkel [°]

axis-length = Länge [m]

axis-line = Zeile [px]

axis-mean_redundancy = mittlerer Redundanzanteil

axis-mean_residual = mittlere Verbesserung [px]

axis-motion = { $kind ->
        [velocity] Geschwindigkeit
        *[rotation] Drehung
    } [{ $unit }]

axis-observed_minus_adjusted = beobachtet − ausgeglichen [{ $unit }]

axis-panorama = { $angle ->
        [direction] Richtung
        *[elevation] Höhenwinkel
    } [°]

axis-radius = Abstand vom Bildhauptpunkt [mm]

axis-rays_per_point = Strahlen je Punkt

axis-redundancy_number = Redundanzanteil

axis-residual_in = Verbesserung in { $axis } [px]

axis-right = rechts

axis-right_in = rechts [{ $unit }]

axis-rigorous_minus_rpc = streng − RPC [px]

axis-rms = RMS [px]

axis-rms_residual = RMS der Verbesserungen [px]

axis-sigma = σ { $axis } [{ $unit }]

axis-sigma_of_point = σ eines Punktes [{ $unit }]

axis-standard_deviation = Standardabweichung [{ $unit }]

axis-time = Zeit [s]

axis-time_from_first_line = Zeit seit der ersten Zeile [s]

axis-up = oben

axis-up_in = oben [{ $unit }]

axis-way_flown = Flugweg [{ $unit }]

axis-smallest_blunder = kleinster aufdeckbarer grober Fehler [px]

axis-image_coordinates = Bildkoordinaten

axis-normalised_residual = normierte Verbesserung

axis-days = Tage

axis-displacement = Verschiebung [mm]
