scene_datum = { $system } a une autre référence que les scènes (WGS 84) : { NUM($off_m, decimals: 2) } m à 10 km.
