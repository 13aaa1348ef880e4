reference-unknown = { $kind ->
        [camera] Die Kamera
        [image] Das Bild
        [point] Der Punkt
       *[sensor] Der Sensor
     } { $name } fehlt in { $where }.
    .do = Den Verweis korrigieren oder in { $where } ergänzen.
