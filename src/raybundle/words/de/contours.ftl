contours-none = Bei einem Intervall von { NUM($interval, digits: 6) } gibt es keine Höhenlinie.
    .why = Die Höhen reichen von { NUM($low, digits: 6) } bis { NUM($high, digits: 6) }.
    .do = { OPTION("interval") } kleiner wählen.

contours-interval_too_small = Der Abstand { $interval } { $unit } ist kleiner als zwei Standardabweichungen einer Höhe ({ NUM($sigma, digits: 2) } { $unit }).
    .why = Benachbarte Linien sind nicht unterscheidbar.
    .do = Wählen Sie einen größeren Abstand.
