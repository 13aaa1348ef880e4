gps = Die Positionen von { $n } { $n ->
     [one] Aufnahme
     *[other] Aufnahmen
    } sind beobachtet{ $flights ->
     [0] { "" }
     [one] { "" }, mit einem geschätzten gemeinsamen Versatz
     *[other] { "" }, mit einem geschätzten Versatz für jeden von { $flights } Flügen
    }.
