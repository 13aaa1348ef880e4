exterior_list-touching = Deux nombres se touchent : { $value }.

exterior_list-columns = Une ligne sans noms de colonnes a { $n } colonnes.

exterior_list-angle_size = { $value } n'est pas un angle en degrés, gon ou radians.
