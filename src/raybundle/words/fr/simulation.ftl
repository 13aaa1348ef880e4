simulation-too_few_points = Simulation : seuls { $n } points ont { $rays } rayons.

simulation-point_not_visible = Bloc { $block } : la photo { $image } ne peut pas montrer le point { $point } depuis sa station.

simulation-has_scenes = Le bloc { $block } a des scènes satellite ; seules des photos peuvent être simulées.

simulation-point_unknown = Bloc { $block } : le point { $point } n'a pas de coordonnées.

simulation-control_without_sigma = Bloc { $block } : le point d'appui { $point } n'a pas d'écart-type.

simulation-control_layout = Il n'y a pas de disposition pour { $n } points d'appui.

simulation-too_few_photographs = { $n } des { $total } photos du vol montrent { $least } points de liaison ; il en faut deux.

simulation-unknown_scene = { $name } n'est ni une scène, ni le dossier d'un plan ou d'un bloc.

simulation-setting_of_scenes = { OPTION($setting) } concerne les scènes ; { $folder } a ses propres appuis et barres d'échelle.
