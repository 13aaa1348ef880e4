target-no_such_id = La famille de cibles { $family } n'a pas de numéro { $ids_missing }.

target-unknown_ring_family = La famille de cibles { $name } est inconnue.

target-image_type = Les cibles ne peuvent pas être détectées dans une image de type { $kind } et de forme ({ $shape }).

target-unknown_tags = Les marqueurs { $name } sont inconnus.

target-unknown_family = La famille de cibles { $name } est inconnue.

target-too_few_codes = La famille de cibles { $family } a { $n } cibles ; { $wanted } sont demandées.

target-table_settings = { OPTION("table") } et { OPTION("bits") } vont ensemble et excluent d'autres cibles.

target-needs_photographs = { OPTION("target") } et { OPTION("dots") } concernent les photographies ; { $name } est un résultat.

target-family_missing = La famille des cibles n'est pas nommée.

target-code_form = { OPTION("codes", $text) } : { $word } n'est ni un nombre ni une plage.

target-code_range = { OPTION("codes") } : { $word } dépasse les { $most } cibles possibles.

target-code_twice = { OPTION("codes", $text) } : un numéro figure deux fois, ou une plage décroît.

target-family_twice = Familles de cibles données deux fois : { $names }.

target-family_ambiguous = Les cibles de { $photographs } photographies conviennent à plusieurs familles.

target-family_points = { $family } : { $n } points.

target-board_ambiguous = { $board ->
        [raster] Une grille de points
       *[chessboard] Un échiquier
    } est visible, mais sa taille est ambiguë : { $names }.
