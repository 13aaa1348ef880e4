pixel_shape = Kamera { $camera }: { $shear ->
        [yes] Scherung
       *[no] Affinität
     } { $symbol } von { NUM($found, digits: 2) } ± { NUM($sigma, digits: 1) } ist für einen Sensor unmöglich (Grenze { NUM($limit, digits: 1) }).
    .why = Der Parameter ist festgehalten; Ursache können Bewegung beim Auslesen, durch ungleiches Licht verschobene Kanten oder schwache Geometrie sein, und Standardabweichungen sind womöglich zu klein.
    .do = Bei einem Scan oder einer alten Kamera: neu ausgleichen, mit diesem Parameter in { OPTION("free") } (raybundle adjust).
