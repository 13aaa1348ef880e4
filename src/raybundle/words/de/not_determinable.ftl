not_determinable = Kamera { $name }: { $symbol } ist nicht bestimmbar (Standardabweichung { NUM($sigma, digits: 2) } { $unit }).
    .why = Die Aufnahmen bestimmen den Parameter ungenauer, als er vorher bekannt ist.
    .do = { $remedy ->
        [converge] Den Parameter festhalten oder Bilder ergänzen, die um 45° oder mehr konvergieren, oder Punkte in verschiedenen Tiefen.
        [roll] Zwei um 90° verkantete Bilder ergänzen.
        [views] Den Parameter festhalten oder konvergente Bilder ergänzen.
       *[corners] Den Parameter festhalten oder Punkte bis in die Ecken des Formats messen.
     }
