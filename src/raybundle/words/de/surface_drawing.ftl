surface_drawing-line_or_area = Ecken einer Linie oder einer Fläche sind nötig, nicht von beiden.
    .do = { OPTION("line", flag: "x") } oder { OPTION("area", flag: "x") } angeben.

surface_drawing-none = Auf { $surface } ist nichts gezeichnet.
    .why = { $n ->
        [0] Das Projekt hat keine Zeichnungen.
       *[other] { $n } Zeichnungen liegen auf anderen Oberflächen oder Layern.
     }
    .do = Im Studio zeichnen (Produkte, Plan) oder mit raybundle mark draw.

surface_drawing-no_heights = Die Oberfläche hat an keiner Ecke von { LIST($names, most: 5) } eine Höhe.
    .do = Innerhalb der Oberfläche zeichnen oder Löcher mit { OPTION("fill", "WIDTH") } füllen.

surface_drawing-no_layer = Keine Zeichnung liegt auf Layer { LIST($names, most: 5) }.
    .why = Layer sind: { LIST($known, most: 10) }.
    .do = Einen dieser Namen verwenden.

surface_drawing-written = { $n } { $n ->
        [one] Zeichnung
       *[other] Zeichnungen
    } auf { LIST($layers, most: 5) }.

surface_drawing-others = { $n } { $n ->
        [one] Zeichnung liegt
       *[other] Zeichnungen liegen
    } auf anderen Oberflächen oder Layern.

surface_drawing-heights_between = Ecken ohne Höhe in { LIST($names, most: 5) }.
    .why = Ihre Höhen folgen aus den Ecken daneben.
    .do = Löcher mit { OPTION("fill", "WIDTH") } füllen.

surface_drawing-left_out = Ohne jede Höhe, weggelassen: { LIST($names, most: 5) }.
    .do = Innerhalb der Oberfläche zeichnen.
