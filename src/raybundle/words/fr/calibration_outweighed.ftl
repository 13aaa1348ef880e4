calibration_outweighed = Caméra { $camera } : le résultat la détermine moins précisément que l'étalonnage donné (limite { NUM($limit, digits: 2) }).

calibration_outweighed-parameter = { $symbol } : écart-type { NUM($before, digits: 2) } avant, { NUM($after, digits: 2) } maintenant
