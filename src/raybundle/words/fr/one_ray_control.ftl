one_ray_control = { $n } point(s) d'appui avec un seul rayon : { $ids }.
