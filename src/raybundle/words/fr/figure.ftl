figure-wrong_type = figure est du type { $type }, pas Figure ou SubFigure.

figure-no_image_points = Aucun point image n'a participé à la compensation ; il n'y a rien à dessiner.

figure-camera_without_points = La caméra { $camera } n'a pas de points image dans la compensation.

figure-no_control = Il n'y a ni points d'appui avec écart-type ni points de contrôle ; il n'y a rien à dessiner.

figure-no_distortion = { $name } n'a ni distorsion ni écarts-types ; il n'y a rien à dessiner.

figure-no_camera = Aucune caméra de la compensation n'a de distorsion à dessiner.

figure-none_of_camera = Il n'y a pas de figures de l'orientation interne { $name }.

figure-no_network = Aucun point objet avec rayons n'a de coordonnées ; il n'y a pas de réseau à dessiner.

figure-no_redundancy_numbers = La compensation n'a pas de nombres de redondance.

figure-no_adjustment = L'argument est du type { $type }, pas Adjustment.
