parallel_rays = { $n } points de liaison ont été exclus : des rayons parallèles n'ont pas de profondeur.
