wide_baselines = { $joined ->
        [one] 1 Aufnahme ist
        *[other] { $joined } Aufnahmen sind
    } durch { $pairs } Paare weiterer Verfahren verbunden: { LIST($methods, most: 3) }.
    .why = Die erste Zuordnung ließ sie weg oder in einem anderen Teil.
