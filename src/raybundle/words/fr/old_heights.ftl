old_heights-too_few = L'ajustement demande { $needed } cellules immobiles ; il y en a { $n }.

old_heights-not_converged = L'autre modèle ne s'ajuste pas : décalage en plan trop grand ({ LIST($shift, most: 2) }).

old_heights-not_determined = La zone stable ne détermine pas le décalage et les inclinaisons de l'autre modèle.

old_heights-plan_undetermined = La zone stable ne détermine pas le décalage en plan vers { NUM($direction_deg, digits: 3) }° : sigma { NUM($sigma, digits: 2) } (limite { NUM($limit, digits: 2) }).

old_heights-no_map = Un modèle sans photos demande une surface dans une carte en mètres.

old_heights-not_needed = { OPTION("stable", "FILE") } vaut pour un modèle sans photos.

old_heights-cloud_cut_off = Le nuage de points est tronqué : { $missing } points sur { $total } manquent.

old_heights-ambiguous = Deux ajustements de l'autre modèle conviennent également : la zone stable n'est pas certaine.

old_heights-narrow = L'ajustement repose sur { PERCENT($share) } % des altitudes communes (limite { PERCENT($limit) } %).

old_heights-far = L'autre modèle s'écarte de { NUM($up, digits: 4) } m en altitude (limite { NUM($limit, digits: 3) } m).

old_heights-other_unit = L'autre modèle a une autre unité : ses dénivelées sont { NUM($ratio, digits: 3) } fois celles de la surface.

old_heights-whole_units = Les altitudes de l'autre modèle sont arrondies à l'unité.
