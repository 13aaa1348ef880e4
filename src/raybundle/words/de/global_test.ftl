global_test = Verbesserungen sind { $sigma0 }-mal so groß wie angegeben (Sigma0; signifikant bei 5 %).
    .why = Die angegebenen Standardabweichungen sind zu klein, das Modell ist unvollständig, oder grobe Fehler sind enthalten; Ergebnisse gelten mit dem geschätzten Sigma0.
    .do = Die größten Verbesserungen prüfen (Quadratsumme { NUM($square_sum, digits: 5) }, 95-%-Grenzen { NUM($lower, digits: 5) } bis { NUM($upper, digits: 5) }).

global_test-nearly = Verbesserungen sind { NUM($percent, digits: 2) } % größer als angegeben (Sigma0 { $sigma0 }).
    .why = Die Abweichung ist signifikant (Quadratsumme { NUM($square_sum, digits: 5) }, 95-%-Grenzen { NUM($lower, digits: 5) } bis { NUM($upper, digits: 5) }), aber unter { $limit_percent } %; Ergebnisse gelten mit dem geschätzten Sigma0.

global_test-smaller = Verbesserungen sind { NUM($percent, digits: 2) } % kleiner als angegeben (Sigma0 { $sigma0 }).
    .why = Die Beobachtungen sind genauer als angegeben (Quadratsumme { NUM($square_sum, digits: 5) }, 95-%-Grenzen { NUM($lower, digits: 5) } bis { NUM($upper, digits: 5) }); Ergebnisse gelten mit dem geschätzten Sigma0.

global_test-estimated_weights = Verbesserungen sind { NUM($percent, digits: 2) } % kleiner als bei der Schätzung der Gewichte (Sigma0 { $sigma0 }).
    .why = Das ist kein Zeichen höherer Genauigkeit (Quadratsumme { NUM($square_sum, digits: 5) }, 95-%-Grenzen { NUM($lower, digits: 5) } bis { NUM($upper, digits: 5) }); Ergebnisse gelten mit dem geschätzten Sigma0.
