contours-none = Bei einem Intervall von { NUM($interval, digits: 6) } gibt es keine Höhenlinie.
    .why = Die Höhen reichen von { NUM($low, digits: 6) } bis { NUM($high, digits: 6) }.
    .do = { OPTION("interval") } kleiner wählen.
