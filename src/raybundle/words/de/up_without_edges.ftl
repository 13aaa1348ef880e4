up_without_edges = Lotrichtung aus der Haltung der Kamera, ± { NUM($sigma_deg, digits: 2) }°; lotrechte Kanten wurden nicht gefunden.
