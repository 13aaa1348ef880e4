mask-none_found = Le dossier n'a aucun masque des { $n } photographies.

mask-all_hidden = Les masques excluent { $hidden } photographies sur { $n } ; il en faut deux.

mask-size_differs = Le masque a { $width_px } x { $height_px } px, { $photograph } { $photograph_width_px } x { $photograph_height_px } px.

mask-corner_form = Le sommet { $corner } du polygone est { $word }.

mask-other_name = { $name } diffère des noms d'un masque pour cette photographie.
