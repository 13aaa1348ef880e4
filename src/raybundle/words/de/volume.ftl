volume-base_unknown = { OPTION("above", $value) } ist weder eine Höhe noch der Ordner einer Oberfläche noch { $rim }.
    .do = Eines davon angeben.

volume-rim_needs_outline = Eine Basis entlang des Randes braucht einen Umriss.
    .do = { OPTION("outline", "FILE") } oder { OPTION("above", "HEIGHT") } angeben.

volume-filled_share = { PERCENT($share) } % der Fläche wurden gefüllt (Grenze { $limit_percent } %).
    .do = Die Lücken fotografieren oder es mit { OPTION("most_filled", 100) } zulassen.

volume-no_height = { PERCENT($share) } % der Fläche haben keine Höhe ({ $n } { $n ->
        [one] Zelle
       *[other] Zellen
     }).
    .why = Die Mitte des größten Lochs, bei X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }, ist { $distance } { $unit } von einer Höhe entfernt.
    .do = Es mit { OPTION("fill", $fill) } füllen oder aus dem Umriss ausschließen.
