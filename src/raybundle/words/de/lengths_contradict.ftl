lengths_contradict = Fehler von { $n } { $n ->
        [one] Prüflänge
       *[other] Prüflängen
     } sind { NUM($factor, digits: 2) }-mal so groß wie angegeben (F { $F }, { P($p) }).
    .why = Standardabweichungen von Punkten und Abweichungen sind um etwa diesen Faktor zu klein, oder Kalibrierscheine sind falsch.
    .do = Die Kalibrierscheine der Prüflängen und der Maßstabsstrecken prüfen.

lengths_contradict-scale = Fehler von { $n } { $n ->
        [one] Prüflänge
       *[other] Prüflängen
     } sind { NUM($factor, digits: 2) }-mal so groß wie angegeben (F { $F }, { P($p) }).
    .why = Standardabweichungen von Punkten und Abweichungen sind um etwa diesen Faktor zu klein, oder Kalibrierscheine sind falsch.
    .do = Die Maßstabsstrecken prüfen: Gemessene Längen weichen um { NUM($scale_ppm, digits: 2) } ± { NUM($sigma_ppm, digits: 2) } ppm ab.

lengths_contradict-one = Fehler von { $n } { $n ->
        [one] Prüflänge
       *[other] Prüflängen
     } sind { NUM($factor, digits: 2) }-mal so groß wie angegeben (F { $F }, { P($p) }).
    .why = Ohne { $length } stimmen die übrigen.
    .do = Kalibrierschein und Endpunkte von { $length } prüfen.

lengths_contradict-single = Fehler von { $n } { $n ->
        [one] Prüflänge
       *[other] Prüflängen
     } sind { NUM($factor, digits: 2) }-mal so groß wie angegeben (F { $F }, { P($p) }).
    .do = Kalibrierschein und Endpunkte von { $length } und die Maßstabsstrecken prüfen.

lengths_contradict-length = { $start } - { $end }: Fehler { $error_mm } mm, Sigma { NUM($sigma_mm, digits: 2) } mm.
