mesh-no_triangles = Le maillage { $name } n'a pas de triangles.

mesh-vertex_not_finite = Maillage { $name } : le sommet { $vertex } a une coordonnée qui n'est pas un nombre fini.

mesh-unknown_vertex = Maillage { $name } : un triangle renvoie au sommet { $vertex }, mais il y en a { $n }.

mesh-no_area = Maillage { $name } : ses triangles sont sans surface.

mesh-nothing_to_measure = Maillage { $name } : tous les triangles sont exclus de la mesure.

mesh-not_readable = Le fichier n'est pas lisible comme maillage ({ $detail }).

mesh-too_many_triangles = Le maillage a { $n } triangles ; { $most } au plus sont lus.

mesh-too_small = Le maillage mesure { $extent_mm } mm si son unité est { $unit_m } m ; il faut au moins { $least_mm } mm.
