control_rejected = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und geht nicht in die Ausgleichung ein.
    .do = Seine Koordinaten und seine Nummer in den Bildern prüfen.
