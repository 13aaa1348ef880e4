correlation-contained = Die Standardabweichungen der Punkte enthalten diese Korrelation; sie zählt, wenn die Kalibrierung für andere Aufnahmen dient.

correlation = Kamera { $name }: { $first } und { $second } korrelieren mit { NUM($correlation, decimals: 2) }.
    .do = { $roll ->
        [yes] Kein Bild ist um 90° verkantet: zwei verkantete Bilder ergänzen.
       *[no] { "" }
     }
