id-empty = { $kind ->
        [camera] Caméra
        [image] Image
        [point] Point
       *[instrument] Instrument
     } { $number } sur { $n } : identifiant vide ; rien n'est écrit.

id-twice = { $kind ->
        [camera] Caméras
        [image] Images
        [point] Points
       *[instrument] Instruments
     } { $first } et { $second } : même identifiant { $id } ; rien n'est écrit.
