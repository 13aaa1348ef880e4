calibration_contradicted = Caméra { $camera } : les photos contredisent son étalonnage (chi carré { NUM($squares, decimals: 0) }, limite { NUM($limit, decimals: 1) }).

calibration_contradicted-held = Caméra { $camera } : les photos contredisent son étalonnage fixé (F { $F }, limite { $limit }).

calibration_contradicted-harmless = Caméra { $camera } : les photos contredisent son étalonnage fixé (F { $F }, limite { $limit }).

calibration_contradicted-given = { $symbol } : donné { NUM($given, digits: 9) } { $unit }, trouvé { NUM($found, digits: 9) } { $unit } (|w| { NUM($w, decimals: 1) }, limite { NUM($limit, decimals: 1) })

calibration_contradicted-moved = { $symbol } : fixé { NUM($given, digits: 9) } { $unit }, trouvé { NUM($found, digits: 9) } ± { NUM($sigma, digits: 2) } { $unit } ({ NUM($effect_px, digits: 2) } px)
