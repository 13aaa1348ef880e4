not_significant = Caméra { $camera } : { $symbols } fixé(s) à 0, non significatif(s) (effet sous { NUM($effect_px, digits: 2) } px).
