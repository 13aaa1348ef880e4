bias-unknown_model = Das Bias-Modell { $name } ist unbekannt.
    .do = Eines von { LIST($known, most: 9) } verwenden.

bias-point_count = { $ground } Geländepunkte und { $image } Bildpunkte sind angegeben.
    .do = Mindestens ein Paar und gleich viele von beiden angeben.

bias-misfit = Die Passpunkte passen mit dem Bias { $model } nicht zum RPC: rms { $x_px } px in x, { $y_px } px in y.
    .why = Das ist das { $misfit }-fache ihrer Standardabweichung von { $sigma_px } px (Grenze { $limit }).
    .do = { $better ->
        [yes] Bias { $advised } verwenden
       *[no] Prüfen, ob Punkte und Szene zusammengehören,
     } und prüfen, ob die Höhen ellipsoidisch sind und Pixel von der äußeren Ecke zählen.

bias-not_determined = { $n } { $n ->
        [one] Punkt bestimmt
       *[other] Punkte bestimmen
     } die Korrektur { $model } nicht.
    .do = Punkte ergänzen oder eine andere Korrektur wählen.
