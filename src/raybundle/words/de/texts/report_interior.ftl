report_interior-title = Innere Orientierung

report_interior-name = Kamera { $camera }{ $single ->
        [yes] , Bild { $image }
        *[no] {""}
    }

report_interior-figures_of = Abbildungen: { report_interior-name }

report_interior-tests_of = Tests und Korrelationen: { report_interior-name }

report_interior-camera = Kamera { $camera }{ $single ->
        [yes] , Bild { $image }
        *[no] {""}
    }: Modell { $model }, { $width_px } × { $height_px } px, { NUM($width_mm, digits: 4) } × { NUM($height_mm, digits: 4) } mm, Pixel { NUM($pixel_um, digits: 4) } µm

report_interior-instrument = { $noun ->
        [antenna] Antenne
        *[other] { $noun }
    } { $name }

report_interior-scenes = Parameter der Szenen siehe eigener Abschnitt: { LIST($names, most: 8) }.

report_interior-figures_drawn = Abbildungen gibt es zu { $n } von { $of } inneren Orientierungen.

report_interior-determinability = Bestimmbarkeit

report_interior-effect = Wirkung

report_interior-effect_of_sigma = Wirkung von σ

report_interior-t_note = t: Wert durch σ.

report_interior-determinability_note = Bestimmbarkeit: 1 = unabhängig von allen anderen Unbekannten; nahe 0 = nur mit ihnen zusammen.

report_interior-effect_note = Wirkung: größte Verschiebung im Format, durch den Wert und durch ein σ.

report_interior-further_parameters = { $n } { $n ->
        [one] weiterer Parameter steht
        *[other] weitere Parameter stehen
    } in result.json.

report_interior-status = { $status ->
        [held] festgehalten
        [estimated] geschätzt
        [observed] beobachtet
        [not_significant] nicht signifikant
        *[not_determinable] nicht bestimmbar
    }

report_interior-of_images = Innere Orientierung jedes Bildes

report_interior-tested_together = zusammen getestet

report_interior-probability = Wahrscheinlichkeit eines größeren F durch Zufall

report_interior-joint_tests = Gemeinsame Tests: Können alle null sein?

report_interior-no_distortion = Keine Verzeichnung: Alle zusätzlichen Parameter sind auf ihren Vorgaben festgehalten.

report_interior-correlations = Korrelationen zwischen den Parametern der inneren Orientierung.

report_interior-correlations_exterior = Größte |Korrelation| mit der äußeren Orientierung über alle Bilder der Kamera.

report_interior-uncertainty = Unsicherheit der Abbildung { $infinite ->
        [yes] im Unendlichen
        *[no] in { NUM($distance, digits: 2) } { $unit ->
            [units] Einheiten
            *[other] { $unit }
        } Abstand
    }: höchstens { NUM($largest_px, digits: 2) } px.
    .why = Standardabweichung des Bildes eines Strahls durch Fehler der inneren Orientierung, ohne den Anteil, den die äußere Orientierung aufnimmt.

report_interior-decentring = Tangentiale Verzeichnung: größte Korrektion über alle Richtungen.

report_interior-corrections = Alle Korrektionen über dem Format, von gemessen (Punkt) nach ideal; die größte ist { $largest_px } px.
    .why = Das Kreuz ist der Bildhauptpunkt.

report_interior-extrapolated = Schattiert: Jenseits von { $reach_mm } mm gibt es keine Beobachtungen; die Kurve ist extrapoliert.

report_interior-radial = Radiale Korrektion, ideal minus gemessen.

report_interior-balanced = Ausgeglichen: dieselbe Verzeichnung mit einer um { PERCENT($share, digits: 3) } % geänderten Kammerkonstante.

report_interior-radial_sigma = Ihre Standardabweichung, aus der Kovarianz der radialen Parameter.

report_interior-band = Band: 1 σ (kann schmaler als die Linie sein).
