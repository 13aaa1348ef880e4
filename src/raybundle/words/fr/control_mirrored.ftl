control_mirrored = Les coordonnées d'appui de { $name } sont inversées (image miroir).

control_mirrored-points = Les coordonnées de { $n } points d'appui et de contrôle sont inversées ; aucun n'est utilisé : { LIST($ids, most: 8) }.

control_mirrored-axes = { $geographic ->
     [yes] La latitude et la longitude
     *[no] Les coordonnées est et nord
    } des points d'appui semblent interverties ; aucun n'est utilisé.
