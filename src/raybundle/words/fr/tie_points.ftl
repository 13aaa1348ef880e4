tie_points-too_few_rays = { $n } point(s) de liaison ont moins de deux rayons.

tie_points-no_ray = Points sans rayon : { LIST($points, most: 10) }.

tie_points-single_ray = Points à un seul rayon : { LIST($points, most: 10) }.

tie_points-no_base = Les { $n } paires de photographies appariées n'ont pas de base : elles ne diffèrent que par une rotation.

tie_points-too_few_common = Aucune paire de photographies n'a assez de points de liaison communs pour une orientation relative.

tie_points-none_after_cleaning = Après le rejet des faux appariements, aucune paire n'a assez de points de liaison communs.
