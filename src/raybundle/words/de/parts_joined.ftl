parts_joined = { $parts } Teile des Blocks ({ $photographs } Aufnahmen) haben keine gemeinsamen Punkte.
    .why = Passpunkte oder Positionen verbinden sie.
    .do = Aufnahmen machen, die zwei Teile zugleich zeigen, für eine festere Verbindung.
