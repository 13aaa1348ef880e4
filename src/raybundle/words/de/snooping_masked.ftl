snooping_masked = Grobe Fehler verdecken einander womöglich: Sigma0 ist nach { $rejected } Verwerfungen noch { $sigma0 }.
    .why = Das ist das { NUM($ratio, digits: 2) }-Fache des mittleren Residuums (Median), und kein einzelner Testwert ist signifikant.
    .do = Punktnummern, Näherungswerte und die Standardabweichungen der Bildpunkte prüfen.
