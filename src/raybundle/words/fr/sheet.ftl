sheet-unknown_paper = Le format de papier { $name } est inconnu.

sheet-dot_radius_not_positive = Le rayon des disques est { $radius_mm } mm.

sheet-target_too_large = Une cible avec un disque de { $radius_mm } mm de rayon ({ $side_mm } mm) ne tient pas sur { $paper }.

sheet-spacing_not_positive = L'espacement de la mire est { $spacing_mm } mm.

sheet-board_too_large = { $board } de { $spacing_mm } mm demande { $width_mm } x { $height_mm } mm ; { $paper } en a { $room_width_mm } x { $room_height_mm }.

sheet-side_not_positive = Le côté d'un marqueur est { $side_mm } mm.

sheet-no_such_tag = { $family } n'a pas de marqueur { $tag }.

sheet-tag_too_large = Un marqueur de { $side_mm } mm avec sa bordure claire ne tient pas sur { $paper }.

sheet-dots_too_large = Des disques de { $radius_mm } mm de rayon sont trop grands pour un espacement de { $spacing_mm } mm.

sheet-too_many_dots = { $paper } peut recevoir { $most } disques à { $spacing_mm } mm d'espacement ; { $n } sont demandés.

sheet-boards_are_dark = Les mires et les marqueurs carrés ne s'impriment qu'en foncé sur clair.

sheet-not_printable = { $family } ne peut pas être imprimé.

sheet-file_type = Une feuille ne peut pas être écrite dans ce format (suffixe « { $ending } »).

sheet-print_factor = L'impression vaut { NUM($factor, decimals: 3) } fois le dessin (limites 0,95 et 1,05).

sheet-no_sidecar = Ce n'est pas le fichier d'une feuille de cibles : family ou [[pages]] manque.

sheet-target_twice = La cible { $name } figure deux fois.

sheet-ring_radii = Des anneaux de { $radii } mm ne sont pas possibles avec un disque de { $radius_mm } mm de rayon.

sheet-name_no_number = La cible { $name } d'une table de codes propre a un nom qui n'est pas un nombre.

sheet-same_ring = Deux cibles ont le même anneau.

sheet-place_out_of_range = { $value_mm } mm n'est pas une position sur une feuille.

sheet-length_out_of_range = { $value_mm } mm n'est pas une longueur sur une feuille.

sheet-spacing_missing = { $family } : le côté d'un carré ou la distance des points manque.

sheet-dots_without_numbers = Les points n'ont pas de numéros que { OPTION("codes") } pourrait choisir.

sheet-board_without_numbers = { $family } est une mire ; ses points n'ont pas de numéros à choisir.

sheet-other_targets = Les photographies montrent des cibles absentes de la feuille : { LIST($names, most: 10) }.
