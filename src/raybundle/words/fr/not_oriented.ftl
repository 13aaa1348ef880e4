not_oriented-not_connected = L'image n'a pas de liaison avec les autres images.

not_oriented-no_second_image = L'image a { $n } points connus, et aucune deuxième image n'a assez de points communs.

not_oriented-few_common = L'image a { $n } points communs avec les autres ; il en faut { $least }.

not_oriented-no_pose = L'image a { $n } points communs avec les autres, mais aucune orientation ne convient à { PERCENT($share) } % d'entre eux.

not_oriented-contradicting_part = Les points de cette image et de { $n } autres, orientées ensemble, contredisent les autres images.

not_oriented-axes = { $n } points de l'image conviennent avec d'autres axes image ({ $axes }).

not_oriented-no_base = Images { $first } et { $second } : les rayons vers les points communs sont parallèles à { NUM($angle_deg, decimals: 2) }° près, sans base.

not_oriented-other_cameras = L'image n'a pas de points communs avec les autres caméras, et trop peu de stations ou de rotations les relient.

not_oriented-station = La station de l'image a { $n } points image dans { $images } images.

not_oriented-contradicting_orientations = Les orientations relatives de la photographie contredisent celles des autres photographies.

not_oriented-contradicting_points = Les points de la photographie contredisent ceux des autres photographies.

not_oriented-no_distance = Moins de { $least } points de la photographie sont dans deux autres ; sa distance n'est pas déterminée.

not_oriented-separate_part = La partie de cette photographie ({ $n } en tout) n'a pas de liaison avec la plus grande ({ $largest } photographies).

not_oriented-wide_baseline = { $n } points de la photographie sont vus de directions à { NUM($angle_deg, decimals: 0) }° (médiane ; limite { NUM($limit_deg, decimals: 0) }°).

not_oriented-few_fit = Seuls { $n } points de la photographie conviennent aux autres.

not_oriented-same_picture = La photographie montre la même image que { $other }.

not_oriented-mirrored = La photographie est inversée par rapport aux autres.

not_oriented-alone = Une seule photographie ne peut pas être orientée ; il en faut deux.

not_oriented-not_joined = La scène n'a pas de liaison avec les photographies.

not_oriented-board = La photographie montre { $n } points du panneau ; il en faut { $least }.

not_oriented-few_targets = { $n } cibles nommées détectées dans la photographie ; il en faut { $least }.

not_oriented-contradicting_share = { $n } des { $points } points de la photographie contredisent les autres photographies.
