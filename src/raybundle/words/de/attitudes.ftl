attitudes = Die Lagewinkel von { $n } { $n ->
     [one] Aufnahme
     *[other] Aufnahmen
    } sind beobachtet ({ $convention }, { $source ->
     [gimbal] vom Gimbal
     *[other] aus { $source }
    }){ $cameras ->
     [0] { "" }
     [one] { "" }, mit der Fehlausrichtung einer Kamera
     *[other] { "" }, mit der Fehlausrichtung von { $cameras } Kameras
    }.
