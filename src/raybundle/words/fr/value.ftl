value-too_large = { $value } dépasse { $largest }, le plus grand nombre lu.

value-not_finite = { $value } n'est pas un nombre fini.

value-not_a_number = { $value } n'est pas un nombre.

value-not_whole = { $value } n'est pas un entier de { $least } à { $most }.

value-no_text = { $value } n'est pas un texte imprimable.

value-no_table = Une table ou un objet est attendu ici.

value-no_list = Une liste est attendue ici.

value-key_missing = L'entrée { $name } manque.

value-count = Nombre de valeurs : { $n } ; nécessaire : { $needed }.
