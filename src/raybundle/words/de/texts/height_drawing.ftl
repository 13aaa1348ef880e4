height_drawing-regions_moved = { $n ->
        [0] Kein Bereich hat sich signifikant gegen den Rest bewegt
        [one] 1 Bereich hat sich signifikant gegen den Rest bewegt
        *[other] { $n } Bereiche haben sich signifikant gegen den Rest bewegt
    }

height_drawing-movement = Bewegung gegen den Rest { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] [{ $unit }]
    }: + (rot) { $upright ->
        [yes] nach oben, - (blau) nach unten
        *[no] zum Betrachter, - (blau) von ihm weg
    }

height_drawing-swatch = { $state ->
        [moved] umrandet: signifikante Bewegung
        [chance] blass: nicht signifikant
        *[unknown] schraffiert: nicht in beiden eine Höhe
    }

height_drawing-smallest_movements = Mit einer Wahrscheinlichkeit von 80 % gefunden, Median über die Oberfläche { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] [{ $unit }]
    }: { LIST($movements, most: 8) }

height_drawing-no_height = { $name }: keine Höhe entlang der Linie

height_drawing-axis = { $axis ->
        [distance] Entfernung
        *[height] Höhe
    } { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] [{ $unit }]
    }

height_drawing-band = Band: { $factor } Sigma{ $stretch ->
        [0] {""}
        *[other] ; Höhen { $stretch }-mal so groß wie Entfernungen
    }

height_drawing-contours = links { NUM($left, digits: 10) }, oben { NUM($top, digits: 10) }, Breite { NUM($width, digits: 6) }, Intervall { NUM($interval, digits: 6) } { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] { $unit }
    }

height_drawing-volumes = Band: 95 %; signifikante Änderungen: { $n } von { $total }

height_drawing-axis_volume = Volumen { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] [{ $unit }3]
    }

height_drawing-detectable = Kleinste nachweisbare Bewegung (Macht 80 %) auf { $side } x { $side } { $unit ->
        [none] (ohne Einheit: Der Maßstab ist frei)
        *[other] { $unit }
    }

height_drawing-detectable_swatch = { $state ->
        [unknown] grau: für diese Größe nicht bekannt
        *[untested] schraffiert: nicht getestet, nicht in beiden eine Höhe
    }
