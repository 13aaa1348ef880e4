tie_points-too_few_rays = { $n } point(s) de liaison ont moins de deux rayons.

tie_points-no_ray = Aucun rayon : { LIST($points, most: 10) }

tie_points-single_ray = Un seul rayon : { LIST($points, most: 10) }
