target-no_such_id = La famille de cibles { $family } n'a pas de numéro { $ids_missing }.

target-unknown_ring_family = La famille de cibles { $name } est inconnue.

target-image_type = Les cibles ne peuvent pas être détectées dans une image de type { $kind } et de forme ({ $shape }).

target-unknown_tags = Les marqueurs { $name } sont inconnus.

target-unknown_family = La famille de cibles { $name } est inconnue.

target-too_few_codes = La famille de cibles { $family } a { $n } cibles ; { $wanted } sont demandées.

target-table_settings = { OPTION("table") } et { OPTION("bits") } vont ensemble et excluent d'autres cibles.
