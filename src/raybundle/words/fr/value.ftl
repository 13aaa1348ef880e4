value-too_large = { $value } dépasse { $largest }, le plus grand nombre lu.

value-not_finite = { $value } n'est pas un nombre fini.

value-not_a_number = { $value } n'est pas un nombre.

value-not_whole = { $value } n'est pas un entier de { $least } à { $most }.

value-no_text = { $value } n'est pas un texte imprimable.

value-no_table = Une table ou un objet est attendu ici.

value-no_list = Une liste est attendue ici.

value-key_missing = L'entrée { $name } manque.

value-count = Nombre de valeurs : { $n } ; nécessaire : { $needed }.

value-no_whole_number = { $value } n'est pas un entier, ou est trop grand.

value-not_supported = { $value } n'est pas pris en charge.

value-no_truth_value = { $value } n'est ni true ni false.

value-list_empty = La liste est vide.

value-not_above = { $value } n'est pas supérieur à { $limit }.

value-zero = La valeur est 0.

value-unit_unknown = L'unité { $unit } n'est pas prise en charge.

value-no_time = { $value } n'est pas une date avec heure.

value-size_out_of_range = { $value } est hors limites : un nombre est 0, ou compris entre { $least } et { $most } en valeur absolue.

value-no_length = { $value } n'est pas une longueur.

value-no_number_or_text = { $value } n'est ni un nombre ni un texte.

value-not_one_of = { $entry } = { $given } est inconnu.

value-table_too_large = La table, ou un de ses blocs, a { $size_bytes } octets ; au plus { $limit_bytes } sont lus.
