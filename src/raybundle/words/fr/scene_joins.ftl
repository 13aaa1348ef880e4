scene_joins = Des points de liaison de photographies ont été trouvés dans { $scenes } scènes.

scene_joins-scene = La scène { $scene } contient { $n } points de liaison de photographies.
