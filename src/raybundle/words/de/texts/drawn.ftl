drawn-along_against = Verbesserungen längs { $arc ->
        [yes] des Bogens
        *[no] der Zeile
    } gegen { $angle ->
        [direction] die Richtung
        *[elevation] den Höhenwinkel
    }

drawn-along_line = beobachtet minus ausgeglichen, { $component ->
        [east] Ost
        [north] Nord
        [height] Höhe
        *[other] { $component }
    }, längs { $kind ->
        [antenna] Antenne { $name }
        [positions] der Positionen
        *[attitudes] der Drehungen
    }

drawn-balanced = ausgewogen

drawn-base_to_depth = Basisverhältnisse

drawn-common_points_to = 0 … { $most } gemeinsame Punkte

drawn-correction = Korrektion { $quantity ->
        [position_along_track] der Position längs der Flugrichtung
        [position_across_track] der Position quer zur Flugrichtung
        [height] der Höhe
        [attitude_about_x] des Drehwinkels um x
        [attitude_about_y] des Drehwinkels um y
        *[attitude_about_z] des Drehwinkels um z
    } gegen die Zeit

drawn-corrections = Korrektionen über das Format der Kamera { $camera } { $image }

drawn-correlation_by_distance = Korrelation nach dem Abstand

drawn-correlations = Korrelationen der inneren Orientierung der Kamera { $camera } { $image }

drawn-coverage = Ausnutzung des Bildformats

drawn-depth_map = Tiefenkarte von { $name }

drawn-deviations_of = Standardabweichungen von { $axis }

drawn-distortion = { $kind ->
        [radial] radiale
        *[decentring] tangentiale
    } Verzeichnung der Kamera { $camera } { $image }

drawn-distortion_sigma = Standardabweichung der radialen Verzeichnung der Kamera { $camera } { $image }

drawn-exterior_correlations = Korrelationen mit der äußeren Orientierung

drawn-gaussian = Gauß

drawn-image_points = { $n } { $n ->
        [one] Bildpunkt
        *[other] Bildpunkte
    }

drawn-image_scales = Bildmaßstäbe

drawn-images = { $n } { $n ->
        [one] Bild
        *[other] Bilder
    }

drawn-images_to = 0 … { $most } Bilder

drawn-intersection_angles = Schnittwinkel

drawn-its_sigma = deren σ

drawn-jitter = strenges Modell minus RPC entlang der Zeilen

drawn-length_errors = Abweichungen der Längen über den Längen

drawn-mark = { $point }: { $known ->
        [yes] { NUM($residual_px, digits: 2) } px
        *[no] keine Verbesserung
    }{ $rejected ->
        [yes] , verworfen
        *[no] {""}
    }

drawn-marks = markierte Punkte in ihren Bildern mit Verbesserungen

drawn-match_graph = Bilder und ihre gemeinsamen Punkte

drawn-match_matrix = gemeinsame Punkte je zweier Bilder

drawn-mean_residuals = mittlere Verbesserungen der Kamera { $camera }

drawn-mean_residuals_by_radius = mittlere Verbesserungen der Kamera { $camera } gegen den Radius

drawn-motion = { $kind ->
        [velocity] Geschwindigkeit
        *[rotation] Drehung
    } während des Auslesens

drawn-network_views = Grundriss und Seitenansichten des Netzes

drawn-no_observation = keine Beobachtung

drawn-normalised_histogram = Histogramm der normierten Verbesserungen

drawn-normalised_quantiles = Quantile der normierten Verbesserungen

drawn-object = das Objekt { $side ->
        [above] von oben
        *[square] rechtwinklig zur ausgleichenden Ebene
    }, { $n } { $n ->
        [one] Punkt
        *[other] Punkte
    } nach ihrer Standardabweichung gefärbt

drawn-object_colours = Farbe: Standardabweichung einer Koordinate, RMS { $plan ->
        [yes] im Grundriss
        *[no] aus X, Y und Z
    }{ $median ->
        [yes] ; Median benachbarter Punkte
        *[no] {""}
    }.

drawn-object_points = Das Objekt { $side ->
        [above] von oben
        *[square] rechtwinklig zur ausgleichenden Ebene
    }: { $n } { $n ->
        [one] Objektpunkt
        *[other] Objektpunkte
    }.

drawn-object_stations = Kleine Dreiecke: Aufnahmen{ $outside ->
        [0] {""}
        *[other] {" "}({ $outside } außerhalb)
    }.

drawn-overlap = Zahl der Bilder an jeder Stelle

drawn-pair = { $first } – { $second }: { $n } { $n ->
        [one] gemeinsamer Punkt
        *[other] gemeinsame Punkte
    }

drawn-panorama = Richtungen der Bildpunkte und Exzentrizität des Projektionszentrums

drawn-precision_of_points = Präzision der Punkte

drawn-profile = Höhenprofil

drawn-projection_uncertainty = Standardabweichung der Abbildung über das Format

drawn-radial = radial

drawn-ray_map = Objektpunkte nach der Zahl der Strahlen

drawn-redundancy_histogram = Histogramm der Redundanzanteile

drawn-redundancy_map = Redundanzanteile über das Format der Kamera { $camera }

drawn-redundancy_of_images = mittlerer Redundanzanteil jedes Bildes

drawn-residuals_along_track = Verbesserungen in { $axis } längs der Flugrichtung

drawn-residuals_by_radius = Verbesserungen nach dem Radius

drawn-rms_of_images = RMS der Verbesserungen jedes Bildes

drawn-rolls = Kantungen der Bilder

drawn-rpc_bias = Abweichung der RPC über die Szene

drawn-spoke = { $angle_deg }°: { $n } { $n ->
        [one] Bild
        *[other] Bilder
    }

drawn-tangential = tangential

drawn-vector_scale = Maßstab der Vektoren

drawn-vectors = { $kind ->
        [displacements] Verschiebungen
        *[deviations] Abweichungen vom Soll
    }

drawn-vectors_in = { $kind ->
        [displacements] Verschiebungen
        *[deviations] Abweichungen vom Soll
    } { $across ->
        [yes] quer zur ausgleichenden Ebene, von ihrem unteren Rand gesehen
        *[no] in der ausgleichenden Ebene
    }, mit ihrem Maßstab.

drawn-vectors_of_image = Verbesserungsvektoren von Bild { $image }

drawn-photograph_points = Foto { $name } mit { $n ->
        [one] seinem Objektpunkt
        *[other] seinen { $n } Objektpunkten
    } in denselben Farben.

drawn-displacement_over_time = Verschiebung von { $name } über der Zeit
