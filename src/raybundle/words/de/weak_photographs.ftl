weak_photographs = { $weak } von { $photographs } Aufnahmen haben { $common } gemeinsame Punkte mit weniger als zwei anderen: { $ids }.
    .why = Die Orientierung dieser Aufnahmen hängt an einer einzigen Verbindung oder an wenigen Punkten.
    .do = Aufnahmen von Standpunkten zwischen ihnen und den nächsten ergänzen.
