scene_joins = Des points de liaison de photographies ont été trouvés dans { $scenes } scènes.

scene_joins-scene = { $scene } : { $n } points.
