up_without_edges = Verticale tirée de la tenue de l'appareil, ± { NUM($sigma_deg, digits: 2) }° ; aucune arête verticale trouvée.
