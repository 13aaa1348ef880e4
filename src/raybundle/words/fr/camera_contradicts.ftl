camera_contradicts = Caméra { $camera } : l'orientation interne trouvée est impossible pour cette caméra.

camera_contradicts-value = { $symbol } : { NUM($found_px, decimals: 0) } px trouvés, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px connus

camera_contradicts-factor = { $symbol } : { NUM($found_px, decimals: 0) } px trouvés, { NUM($known_px, decimals: 0) } px connus à un facteur { $factor } près
