pixel_shape = Caméra { $camera } : { $shear ->
        [yes] un cisaillement
       *[no] une affinité
     } { $symbol } de { NUM($found, digits: 2) } ± { NUM($sigma, digits: 1) } est impossible pour un capteur (limite { NUM($limit, digits: 1) }).
