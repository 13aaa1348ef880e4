relation-no_list = { $value } n'est pas une liste de relations.

relation-incomplete_entry = L'entrée { $number } n'est pas une relation.
