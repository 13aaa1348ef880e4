parts_apart = Die { $what ->
        [photograph] Aufnahmen
        [scene] Szenen
        [panorama] Panoramen
       *[image] Bilder
    } bilden { $parts } Teile ohne Verbindung; dieses Ergebnis enthält { $n } davon.
    .do = Aufnahmen von beiden Seiten jeder Lücke machen oder in jedem Teil drei Passpunkte markieren.

parts_apart-scenes = Die { $what ->
        [photograph] Aufnahmen
        [scene] Szenen
        [panorama] Panoramen
       *[image] Bilder
    } bilden { $parts } Teile ohne Verbindung; dieses Ergebnis enthält { $n } davon.
    .do = Drei Punkte in den Szenen und in zwei Aufnahmen jedes anderen Teils markieren.

parts_apart-part = { $folder }: { $photographs ->
        [0] {""}
        [one] 1 Aufnahme
       *[other] { $photographs } Aufnahmen
    }{ $panoramas ->
        [0] {""}
        [one] {" "}1 Panorama
       *[other] {" "}{ $panoramas } Panoramen
    }{ $scenes ->
        [0] {""}
        [one] {" "}1 Szene
       *[other] {" "}{ $scenes } Szenen
    } ({ LIST($names, most: 3) }).
