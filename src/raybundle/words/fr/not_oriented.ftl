not_oriented-not_connected = Elle n'a pas de liaison avec les autres images.

not_oriented-no_second_image = { $n } points connus, et aucune deuxième image avec assez de points communs.

not_oriented-few_common = { $n } points communs avec les autres ; il en faut { $least }.

not_oriented-no_pose = { $n } points communs avec les autres, mais aucune orientation ne convient à { PERCENT($share) } % d'entre eux.

not_oriented-contradicting_part = Orientée avec { $n } autres, mais leurs points contredisent ceux des autres images.

not_oriented-axes = { $n } d'entre eux conviennent avec d'autres axes image ({ $axes }).

not_oriented-no_base = Images { $first } et { $second } : les rayons vers les points communs sont parallèles à { NUM($angle_deg, decimals: 2) }° près, sans base.

not_oriented-other_cameras = Elle n'a pas de points communs avec les autres caméras, et trop peu de stations ou de rotations les relient.

not_oriented-station = Sa station a { $n } points image dans { $images } images.

not_oriented-contradicting_orientations = Ses orientations relatives contredisent celles des autres photographies.

not_oriented-contradicting_points = Ses points contredisent ceux des autres photographies.

not_oriented-no_distance = Moins de { $least } de ses points sont dans deux autres photographies ; sa distance n'est pas déterminée.

not_oriented-separate_part = Elle n'a pas de liaison avec la plus grande partie ({ $largest } photographies) ; sa propre partie en a { $n }.

not_oriented-wide_baseline = Ses { $n } points sont vus de directions à { NUM($angle_deg, decimals: 0) }° (médiane ; limite { NUM($limit_deg, decimals: 0) }°).

not_oriented-few_fit = Seuls { $n } de ses points conviennent aux autres.

not_oriented-same_picture = Elle montre la même image que { $other }.

not_oriented-alone = Une seule photographie ne peut pas être orientée ; il en faut deux.

not_oriented-not_joined = Elle n'a pas de liaison avec les photographies.

not_oriented-board = Elle montre { $n } points du panneau ; il en faut { $least }.

not_oriented-few_targets = { $n } cibles nommées détectées ; il en faut { $least }.

not_oriented-contradicting_share = { $n } de ses { $points } points contredisent les autres photographies.
