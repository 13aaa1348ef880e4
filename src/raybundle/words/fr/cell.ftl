cell-empty = La cellule est vide.

cell-grouped_thousands = { $value } contient un séparateur de milliers.

cell-not_a_number = { $value } n'est pas un nombre.

cell-counts_as_zero = { $value } vaut 0 ; il faut une valeur supérieure à 0.

cell-not_positive = { $value } n'est pas supérieur à 0.

cell-negative_sigma = { $value } est négatif ; un écart-type est nul ou positif.

cell-unprintable = { $value } contient des caractères non imprimables.

cell-no_id = { $value } n'est pas un identifiant valable.

cell-id_twice = L'identifiant { $id } figure deux fois, d'abord à la ligne { $earlier }.

cell-unknown_id = { $id } ne figure pas dans { $table }.

cell-not_a_flag = { $value } n'est ni 1 ni vide.
