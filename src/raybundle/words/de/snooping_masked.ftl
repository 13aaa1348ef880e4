snooping_masked = Grobe Fehler verdecken einander womöglich: Sigma0 ist nach { $rejected } verworfenen Beobachtungen noch { $sigma0 }.
    .why = Das ist das { NUM($ratio, digits: 2) }-Fache der mittleren Verbesserung (Median), und keine einzelne Testgröße ist signifikant.
    .do = Punktnummern, Näherungswerte und die Standardabweichungen der Bildpunkte prüfen.
