weak_convergence = Keine Konvergenz: Schritte betragen nach { $iterations } Iterationen noch { NUM($step_sigmas, digits: 1) } Standardabweichungen.
    .why = Eine Unbekannte ist kaum bestimmt.
    .do = Prüfen, welche Standardabweichungen groß sind, und dort Beobachtungen ergänzen.
