reference-unknown = { $kind ->
        [camera] Caméra
        [image] Image
        [point] Point
       *[sensor] Capteur
     } { $name } : absent de { $where }.
