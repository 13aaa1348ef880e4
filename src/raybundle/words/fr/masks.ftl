masks = { $n } des { $photographs } photographies ont un masque.
