not_significant = Kamera { $camera }: { $symbols } auf 0 gesetzt, nicht signifikant (Wirkung unter { NUM($effect_px, digits: 2) } px).
    .why = Solche Werte kommen zufällig mit der Wahrscheinlichkeit { NUM($p, digits: 2) } vor; ohne sie ist das BIC um { NUM($bic, decimals: 1) } kleiner.
