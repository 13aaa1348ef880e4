wide_baselines = { $joined ->
        [one] 1 Aufnahme ist
        *[other] { $joined } Aufnahmen sind
    } durch { $pairs } Paare weiterer Verfahren verbunden: { $methods }.
    .why = Die erste Zuordnung ließ sie weg oder in einem anderen Teil.
