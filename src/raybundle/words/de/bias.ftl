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

bias-points_excluded = { $n } von { $total } Punkten { $n ->
        [one] ist
        *[other] sind
    } ausgeschlossen.

bias-improvement = Der Bias { $model } verbessert die Anpassung signifikant: { $test ->
        [F] F
        *[other] Chi-Quadrat
    } { $value } übersteigt { $limit }.
    .why = { $few ->
        [yes] Es gibt zu wenige Punkte, um einen auszulassen.
       *[no] Ausgelassene Punkte werden auf { $left_out_px } px vorhergesagt (vorher: { $before_px } px).
     }
    .do = Den Bias { $model } verwenden.

bias-rpc_contradicted = Kein Bias ist zu empfehlen: { $larger ->
        [yes] Kein größeres Modell passt signifikant besser
        *[no] Kein größeres Modell ist möglich
    }, aber die Punkte widersprechen den RPC.
    .why = Die Verbesserungen sind { $misfit }-mal so groß wie das Sigma von { $sigma_px } px; Positionen aus diesen RPC sind ebenso falsch.
    .do = Punkte, Koordinatensystem und Höhen prüfen oder Punkte für ein größeres Modell ergänzen.

bias-rpc_confirmed = Kein Bias ist nötig: Die RPC stimmen mit den Punkten im Rahmen des Sigmas von { $sigma_px } px überein.
    .do = Die RPC ohne Korrektur verwenden.
