projective-not_metric = Aucune distance principale ne rend métrique le modèle projectif.

projective-no_pair = Aucune paire d'images ne détermine une matrice fondamentale.

projective-pair = La paire { $image } et { $other } n'a pas de matrice fondamentale.
