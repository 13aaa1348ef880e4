control_rejected = Passpunkt { $point } widerspricht den übrigen Beobachtungen (|w| { NUM($w, decimals: 1) }) und nimmt nicht teil.
    .do = Seine Koordinaten und seine Nummer in den Bildern prüfen.
