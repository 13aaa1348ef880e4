scale_bar-length = Barre d'échelle { $start } - { $end } : la longueur est { $length_m } m.

scale_bar-sigma = Barre d'échelle { $start } - { $end } : l'écart-type est { $sigma_m } m.

scale_bar-too_few_rays = Barre d'échelle { $start } - { $end } : ses extrémités exigent au moins deux rayons chacune.

scale_bar-end_not_measured = Barre d'échelle { $start } - { $end } : le point { $point } n'est mesuré dans aucune photographie.
