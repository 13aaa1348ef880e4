excluded-undetermined = Die verbliebenen Punkte bestimmen die Orientierung des Bildes nicht.
    .do = Mehr Punkte im Bild messen.

excluded-few_points = Die { $n } verbliebenen Punkte bestimmen die Orientierung des Bildes nicht.
    .do = Mehr Punkte im Bild messen.

excluded-part = Ein getrennter Teil von { $photographs } Aufnahmen ist nicht bestimmt.
