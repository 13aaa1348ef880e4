snooping_robust = { $rejected } Bildbeobachtungen wurden nach einer robusten Schätzung verworfen.
    .why = Die groben Fehler verdeckten einander im Test einzelner Beobachtungen (Sigma0 beim { NUM($ratio, digits: 2) }-Fachen der mittleren Verbesserung).
