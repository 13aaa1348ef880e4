id-empty = { $kind ->
        [camera] Caméra
        [image] Image
        [point] Point
        [position] Position
       *[instrument] Instrument
     } { $number } sur { $n } : identifiant vide ; rien n'est écrit.

id-twice = { $kind ->
        [camera] Caméras
        [image] Images
        [point] Points
        [position] Positions
       *[instrument] Instruments
     } { $first } et { $second } : même identifiant { $id } ; rien n'est écrit.
