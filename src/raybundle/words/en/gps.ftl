# $n = 18
# $flights = 1
gps = The positions of { $n } { $n ->
     [one] photograph is
     *[other] photographs are
    } observed{ $flights ->
     [0] { "" }
     [one] { "" }, with one common offset estimated
     *[other] { "" }, with an offset estimated for each of { $flights } flights
    }.
