target_without_normal = { $n } runde { $n ->
     [one] Zielmarke ist nicht um ihre
     *[other] Zielmarken sind nicht um ihre
    } Exzentrizität korrigiert, da die Normale unbekannt ist: { $ids }.
    .do = Die Spalten nX, nY, nZ angeben oder vier Zielmarken in einer Ebene.
