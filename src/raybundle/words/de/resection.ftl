resection-too_few_points = { $n } Punkte sind gegeben; ein Rückwärtsschnitt braucht drei.
    .do = Mehr Punkte messen.

resection-in_line = Die Punkte des Rückwärtsschnitts liegen auf einer Geraden.
    .do = Einen Punkt daneben messen.

resection-no_fit = Keine Orientierung passt zu vier der Punkte auf { $limit_px } px.
    .do = Die Namen der Punkte prüfen.

resection-no_solution = Keine Orientierung bildet die Punkte dort ab, wo sie gemessen sind.
    .do = Die Namen der Punkte prüfen.
