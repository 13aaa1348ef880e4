optical_bar-corrections = La réfraction est appliquée, l'aberration ne l'est pas, comme dans l'Ames Stereo Pipeline.

optical_bar-rotation = iR n'est pas une rotation (écart { NUM($deviation, digits: 2) }), ou l'image n'a qu'une colonne.

optical_bar-sweep = Le balayage atteint { NUM($degrees, digits: 3) }° depuis son milieu ; { NUM($limit, digits: 2) }° sont possibles.
