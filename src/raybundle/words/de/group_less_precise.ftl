group_less_precise = Verbesserungen ({ observations-kind }) sind { NUM($ratio, digits: 3) }-mal so groß wie angegeben (alle Beobachtungen: { $sigma0 }).
    .why = Das ist für { $count } Werte mit Redundanz { NUM($redundancy, decimals: 1) } signifikant.
    .do = Nach einer gemeinsamen Ursache suchen, etwa einem falschen Datum, oder die Standardabweichungen um diesen Faktor vergrößern.

group_less_precise-weighted = Verbesserungen ({ observations-kind }) sind { NUM($ratio, digits: 3) }-mal so groß wie angegeben.
    .why = Die Standardabweichungen dieser Beobachtungen wurden um diesen Faktor vergrößert ({ $count } Werte, Redundanz { NUM($redundancy, digits: 3) }); das ist nur für zufällige Fehler richtig.
    .do = Nach einer gemeinsamen Ursache suchen, etwa einem falschen Datum oder einer Verschiebung der Positionen.
