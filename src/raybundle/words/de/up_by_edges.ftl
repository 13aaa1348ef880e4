up_by_edges = Lotrichtung aus { $edges } lotrechten Kanten in { $photographs } Aufnahmen, ± { NUM($sigma_deg, digits: 2) }°.
