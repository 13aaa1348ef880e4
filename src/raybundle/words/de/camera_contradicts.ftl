camera_contradicts = Kamera { $camera }: Die gefundene innere Orientierung ist für diese Kamera unmöglich.
    .why = Orientierungen und ihre Standardabweichungen sind nicht verlässlich (Chi-Quadrat { NUM($squares, decimals: 0) } aus { $n }, Grenze { NUM($limit, decimals: 1) } bei { $level_percent } %).
    .do = { OPTION("calibration") } angeben, auch für beschnittene Aufnahmen oder ein ungewöhnliches Objektiv, oder konvergente und verkantete Aufnahmen machen.

camera_contradicts-value = { $symbol }: { NUM($found_px, decimals: 0) } px gefunden, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px bekannt

camera_contradicts-factor = { $symbol }: { NUM($found_px, decimals: 0) } px gefunden, { NUM($known_px, decimals: 0) } px bekannt bis auf den Faktor { $factor }
