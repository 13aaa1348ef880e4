images_mirrored-mend = { $mend ->
     [y_up] y der Bildpunkte ist nach oben gezählt
     [x_left] x der Bildpunkte ist nach links gezählt
     [xy_negative] x und y der Bildpunkte sind vertauscht, mit falschen Vorzeichen
     *[xy] x und y der Bildpunkte sind vertauscht
    }

images_mirrored = Das Objekt ist ein Spiegelbild der gegebenen Orientierung, die gespiegelt auf { NUM($misfit, digits: 2) } ihrer Ausdehnung passt.
    .do = observations.csv korrigieren: x zählt nach rechts, y nach unten. Ursache:
