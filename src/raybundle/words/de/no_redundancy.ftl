no_redundancy = Die Ausgleichung hat keine Redundanz.
    .why = Sigma0 lässt sich nicht schätzen, und kein grober Fehler ist zu finden; Standardabweichungen gelten mit dem Sigma0 a priori.
    .do = Beobachtungen ergänzen.
