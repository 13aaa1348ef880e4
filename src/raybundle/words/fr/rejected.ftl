rejected = { $n } observations image sur { $observations } ont été rejetées.

rejected-kind = { $kind ->
        [blunder] Fautes
        [blunder_not_located] Fautes dans un des rayons d'un point
        [behind_camera] Points derrière la caméra
        [rays_diverge] Rayons divergents
        [single_ray] Points à un seul rayon restant
        [residual] Grands résidus
       *[given] Écartées d'avance
     } : { $n }
