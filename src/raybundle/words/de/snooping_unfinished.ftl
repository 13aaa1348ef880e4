snooping_unfinished = Das Data-Snooping endete nach { $rounds } Runden; verdächtige Beobachtungen sind noch enthalten.
    .why = Verbliebene grobe Fehler verfälschen das Ergebnis.
    .do = Die verdächtigen Beobachtungen im Bericht prüfen.
