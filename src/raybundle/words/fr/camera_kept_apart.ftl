camera_kept_apart-not_adjusted = Caméra { $camera } : { $n } des { $photographs } photographies n'ont pas pu être compensées avec les autres.

camera_kept_apart = Caméra { $camera } : { $n } des { $photographs } photographies ont une autre orientation interne.
