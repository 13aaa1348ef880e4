orientation-no_pair = Keine zwei Bilder haben eine relative Orientierung.
    .why = Eine relative Orientierung braucht { $least } gemeinsame Punkte mit Strahlen, die sich schneiden, in verschiedenen Tiefen.
    .do = Prüfen, ob die Bilder ein Objekt von verschiedenen Standpunkten zeigen.

orientation-images_missing = Bilder ohne äußere Orientierung: { $names }.
    .do = Diese Bilder zuerst orientieren.

orientation-not_found = { $n } von { $total } Bildern haben keine genäherte Orientierung.
    .do = Mehr gemeinsame Punkte messen oder Näherungswerte in images.csv angeben.

