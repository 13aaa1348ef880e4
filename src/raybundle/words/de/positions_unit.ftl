positions_unit = Die Höhen der Positionen sind wohl in Fuß; keine Position wird verwendet.
    .why = Die { $n } Positionen passen wie angegeben auf { NUM($before_m, digits: 2) } m zu den Aufnahmen, in Metern auf { NUM($after_m, digits: 2) } m.
    .do = Die Höhen in Metern angeben (Fuß mal 0,3048).
