positions_distant = Die Positionen aus { $table } sind { $distance_km } km von den Positionen in den { $photographs } Aufnahmen entfernt.
    .do = Das Koordinatensystem von { $table } prüfen, und ob die Datei zu diesen Aufnahmen gehört.
