camera_contradicts = Kamera { $camera }: Die gefundene innere Orientierung ist für diese Kamera unmöglich.
    .why = Orientierungen und ihre Standardabweichungen sind nicht verlässlich (Chi-Quadrat { NUM($squares, decimals: 0) } aus { $n }, Grenze { NUM($limit, decimals: 1) } bei { $level_percent } %).
    .do = { OPTION("calibration") } angeben, auch für beschnittene Aufnahmen oder ein ungewöhnliches Objektiv, oder konvergente und verkantete Aufnahmen machen.

camera_contradicts-value = Parameter { $symbol }: { NUM($found_px, decimals: 0) } px gefunden, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px bekannt.

camera_contradicts-factor = Parameter { $symbol }: { NUM($found_px, decimals: 0) } px gefunden, { NUM($known_px, decimals: 0) } px bekannt bis auf den Faktor { $factor }.

camera_contradicts-millimetres = Kamera { $camera }: Die Bildpunkte sind wohl in mm, nicht in Pixeln.
    .why = Die Bildpunkte erstrecken sich über { $x_px } x { $y_px }, wie das Format in mm; es hat { $width_px } x { $height_px } px.
    .do = Pixel von der linken oberen Ecke aus angeben.

camera_contradicts-pixels = Die Pixel haben nicht die angegebene Form: sigma0 ist { $sigma0 } mit anderer Pixelhöhe, { $sigma0_given } wie angegeben.
    .do = pixel_mm prüfen, und ob Bilder umgerechnet wurden. Höhen im Verhältnis zu den angegebenen:

camera_contradicts-pixel_height = Kamera { $camera }: Die Pixelhöhe ist das { NUM($factor, digits: 5) }-Fache der angegebenen.
