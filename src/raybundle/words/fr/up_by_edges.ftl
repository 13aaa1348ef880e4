up_by_edges = Verticale tirée de { $edges } arêtes verticales dans { $photographs } photographies, ± { NUM($sigma_deg, digits: 2) }°.
