excluded-undetermined = Die verbliebenen Punkte bestimmen seine Orientierung nicht.

excluded-few_points = Die { $n } verbliebenen Punkte bestimmen seine Orientierung nicht.

excluded-part = Ein getrennter Teil von { $photographs } Aufnahmen ist nicht bestimmt.
