read_out_unused = { OPTION("read_out", $time_ms) } n'est pas utilisé pour { $cameras } caméras : les vitesses manquent.

read_out_unused-camera = Caméra { $camera } : { $lacking ->
        [times] ses photographies n'ont pas d'heures
        [scale] l'échelle n'est pas déterminée
       *[velocities] photographies avec vitesse : { $n } ; il en faut { $least }
    }.
