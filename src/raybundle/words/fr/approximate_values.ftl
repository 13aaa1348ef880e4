approximate_values-images = { $n } image(s) sans orientation externe : { LIST($images, most: 10) }.

approximate_values-points = { $n } point(s) sans coordonnées : { LIST($points, most: 10) }.

approximate_values-images_beside_scenes = { $n } image(s) sans orientation externe à côté de scènes satellitaires : { $images }.

approximate_values-points_beside_scenes = { $n } point(s) sans coordonnées ni rayons de deux scènes : { $points }.
