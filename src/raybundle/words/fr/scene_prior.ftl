scene_prior-rpc = Les RPC de { $ids } n'ont pas de précision (ERR_BIAS) ; { $sigma_m } m au sol sont supposés.

scene_prior-orbit = { $ids } n'a pas de RPC ; l'attitude du fichier d'orbite est supposée bonne à { $sigma_rad } rad.

scene_prior-radar = La distance et l'horloge de { $ids } sont supposées bonnes à { $sigma_m } m et { $sigma_s } s.
