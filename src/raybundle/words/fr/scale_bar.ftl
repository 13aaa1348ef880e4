scale_bar-length = Barre d'échelle { $start } - { $end } : la longueur est { $length_m } m.

scale_bar-sigma = Barre d'échelle { $start } - { $end } : l'écart-type est { $sigma_m } m.

scale_bar-too_few_rays = Barre d'échelle { $start } - { $end } : ses extrémités exigent au moins deux rayons chacune.

scale_bar-end_not_measured = Barre d'échelle { $start } - { $end } : le point { $point } n'est mesuré dans aucune photographie.

scale_bar-sigma_too_large = Barre d'échelle { $start } - { $end } : l'écart-type { $sigma_m } m dépasse la longueur { $length_m } m.

scale_bar-no_length = Barre d'échelle { $start } - { $end } : ses extrémités sont un seul point ou sans coordonnées.

scale_bar-contradict = Les barres d'échelle se contredisent d'un facteur { $factor }.

scale_bar-given_and_measured = { $bar } : donnée { NUM($given_m, digits: 6) } m, d'après { $pair ->
        [yes] { $others }
       *[no] les autres
     } { NUM($measured_m, digits: 6) } m
