camera_contradicts = Caméra { $camera } : l'orientation interne trouvée est impossible pour cette caméra.

camera_contradicts-value = { $symbol } : { NUM($found_px, decimals: 0) } px trouvés, { NUM($known_px, decimals: 0) } ± { NUM($known_sigma_px, decimals: 0) } px connus

camera_contradicts-factor = { $symbol } : { NUM($found_px, decimals: 0) } px trouvés, { NUM($known_px, decimals: 0) } px connus à un facteur { $factor } près

camera_contradicts-millimetres = Caméra { $camera } : ses points image semblent être en mm, pas en pixels.

camera_contradicts-pixels = Les pixels n'ont pas la forme donnée : sigma0 vaut { $sigma0 } avec une autre hauteur, { $sigma0_given } telle que donnée.

camera_contradicts-pixel_height = Caméra { $camera } : la hauteur du pixel vaut { NUM($factor, digits: 5) } fois celle donnée.
