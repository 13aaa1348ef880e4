up_without_edges = Lotrichtung aus der angenommenen Kamerahaltung, ± { NUM($sigma_deg, digits: 2) }°; lotrechte Kanten wurden nicht gefunden.
