excluded-undetermined = Die verbliebenen Punkte bestimmen die Orientierung des Bildes nicht.
    .do = Mehr Punkte im Bild messen.

excluded-few_points = Die { $n } verbliebenen Punkte bestimmen die Orientierung des Bildes nicht.
    .do = Mehr Punkte im Bild messen.

excluded-part = Ein getrennter Teil von { $photographs } Aufnahmen ist nicht bestimmt.

excluded-few_points_at_date = Zu wenige seiner Punkte haben an seinem Datum einen zweiten Strahl.
