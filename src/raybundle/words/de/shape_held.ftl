shape_held = Kamera { $camera }: { $symbol } ist festgehalten; die Aufnahmen bestimmen den Parameter nur auf { NUM($sigma, digits: 1) }.
    .why = Am besten passt { NUM($found, digits: 2) }, und Sensoren haben weniger als { NUM($limit, digits: 1) }.
