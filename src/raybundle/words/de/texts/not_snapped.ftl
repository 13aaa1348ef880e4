not_snapped-far = Der gefundene Punkt liegt { NUM($distance_px, decimals: 1) } px vom Klick entfernt (Grenze { $limit_px } px).
    .do = Näher klicken.

not_snapped-margin = Das Bild um den Klick ist zu klein.

not_snapped-no_target = Innerhalb von { $reach_px } px liegt keine runde Zielmarke.
    .do = In sie hinein klicken oder eine andere Art wählen.

not_snapped-target_far = Die nächste runde Zielmarke liegt { NUM($distance_px, decimals: 1) } px entfernt (Grenze { $limit_px } px).

not_snapped-no_edges = Innerhalb von { $reach_px } px treffen sich keine Kanten zweier Richtungen.
    .do = Näher an { $kind ->
        [corner] die Ecke
        *[cross] das Kreuz
    } klicken.

not_snapped-other_grey_values = Die Grauwerte sind nicht die { $kind ->
        [corner] einer Ecke
        *[cross] eines Kreuzes
    }.

not_snapped-no_place = Die Grauwerte bestimmen die Lage { $kind ->
        [corner] einer Ecke
        *[cross] eines Kreuzes
    } nicht.

not_snapped-contrast = Der Kontrast beträgt { NUM($contrast, decimals: 0) } Grauwerte (Grenze { $limit }).

not_snapped-angle = Die Kanten treffen sich unter { NUM($angle_deg, decimals: 0) }° (Grenze { NUM($limit_deg, decimals: 0) }°).

not_snapped-grey_values = Die Grauwerte weichen von { $kind ->
        [corner] einer Ecke
        *[cross] einem Kreuz
    } um { NUM($residual, decimals: 2) } des Kontrasts ab (Grenze { $limit }).

not_snapped-sigma = Die Standardabweichung ist { NUM($sigma_px, decimals: 2) } px (Grenze { $limit_px }){ $texture ->
        [yes] {""}
        *[no] : zu wenig Textur
    }.

not_snapped-nothing_alike = Innerhalb von { $reach_px } px gleicht nichts dem anderen Bild (Korrelation { NUM($correlation, decimals: 2) }, Grenze { $limit }).

not_snapped-two_alike = Zwei Stellen im Abstand von { NUM($distance_px, decimals: 1) } px gleichen sich.
    .do = Eine andere Art wählen.

not_snapped-no_convergence = Die Kleinste-Quadrate-Zuordnung konvergiert nicht ({ $outcome }).

not_snapped-correlation = Die Bilder korrelieren nur mit { NUM($correlation, decimals: 2) } (Grenze { $limit }).
