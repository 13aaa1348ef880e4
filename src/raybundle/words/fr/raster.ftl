raster-height_unit_missing = L'unité des hauteurs est inconnue ; les coordonnées sont en { $unit }.

raster-dem_unit_missing = L'unité des hauteurs est inconnue ; les coordonnées sont en { $unit }.

raster-ellipsoidal_heights = Les hauteurs sont déjà ellipsoïdales ({ $system }).

raster-geoid_and_undulation = Un géoïde et une ondulation s'excluent.

raster-geoid_unknown = { $geoid } n'est pas un système vertical connu.

raster-geoid_differs = Les hauteurs du fichier sont { $own }, non { $geoid }.

raster-degrees = Le raster est en degrés ({ $system }) ; il faut un système plan.

raster-no_system = Le raster n'a pas de système de coordonnées.

raster-band_missing = Le raster n'a pas de bande { $band } ; il en a { $n }.

raster-unit_unknown = L'unité { $unit } des hauteurs est inconnue.

raster-unit_differs = Les hauteurs du fichier sont en { $own }, non en { $unit }.

raster-too_many_cells = La zone a { $n } cellules ; { $most } au plus sont lues.

raster-no_overlap = Le raster ne couvre pas la zone.

raster-no_height = Le raster n'a aucune hauteur dans la zone.

raster-impossible_heights = Une hauteur de { $height_m } m n'existe pas sur Terre (hauteurs { $lowest_m } à { $highest_m } m).

raster-not_readable = Le raster est illisible ({ $detail }).

raster-transformed = { $name } est en { $system ->
        [degrees] degrés
        *[other] { $system }
    } ; ses altitudes sont transformées vers { $target }, cellules de { $cell_m } m.

raster-feet = { $name } : les altitudes en pieds sont converties en mètres.

raster-unit_assumed = { $name } ne définit pas l'unité des altitudes ; le mètre est supposé.
