camera_constant = Kamera { $camera }: Die Kamerakonstante ist nicht gegeben; Näherungswert ist { NUM($c_mm, digits: 4) } mm.
    .why = Er stammt aus { $source ->
        [dlt] einer DLT von Passpunkten ({ $n } Werte)
        [plane] Passpunkten in einer Ebene ({ $n } Werte)
        [pairs] Bildpaaren ({ $n } Werte)
        [projective] einem projektiven Modell von { $n } Bildern
       *[format] der größeren Seite des Bildformats
     }.
    .do = { $parameter } schätzen, wenn der Wert nicht bekannt ist, und im Ergebnis prüfen.
