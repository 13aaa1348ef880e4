shape_held = Caméra { $camera } : { $symbol } est fixé ; les photos ne le déterminent qu'à { NUM($sigma, digits: 1) } près.
