id-empty = { $kind ->
        [camera] Kamera
        [image] Bild
        [point] Punkt
        [position] Position
       *[instrument] Instrument
     } { $number } von { $n } hat eine leere Kennung; nichts wird geschrieben.
    .do = Eine Kennung vergeben.

id-twice = { $kind ->
        [camera] Die Kameras
        [image] Die Bilder
        [point] Die Punkte
        [position] Die Positionen
       *[instrument] Die Instrumente
     } { $first } und { $second } haben dieselbe Kennung { $id }; nichts wird geschrieben.
    .do = Jedem eine eigene Kennung geben.
