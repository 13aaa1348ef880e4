target_radius = Die Radien der Zielmarken sind { NUM($ratio, decimals: 3) } ± { NUM($sigma, decimals: 3) } mal so groß wie in den Bildern; der Faktor ist geschätzt.
