orientation-no_pair = Aucune paire d'images n'a d'orientation relative.

orientation-images_missing = Images sans orientation externe : { $names }.

orientation-not_found = { $n } images sur { $total } n'ont pas d'orientation approchée.

