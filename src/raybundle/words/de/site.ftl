site-limit_not_finite = Eine Grenze des Raums für Standpunkte ist keine endliche Zahl.
    .do = Die Grenzen korrigieren.

site-empty = Der Raum für Standpunkte ist leer: { $axis } von { $low_m } bis { $high_m } m.
    .do = Die kleinere Grenze zuerst angeben.
