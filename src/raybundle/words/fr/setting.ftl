setting-unknown = Le réglage { $name } est inconnu.

setting-wrong_kind = { $name } = { $given } n'est pas possible.

setting-several_values = { $name } = { $given } n'est pas une valeur unique.

setting-quotation_open = { $name } = { $given } : un guillemet n'est pas fermé.

setting-impossible_character = { $name } = { $given } contient un caractère impossible dans un nom de fichier.

setting-word_count = { $name } = { $given } n'a pas la forme { $form }.

setting-no_text = { $name } = { $given } n'est pas un texte.

setting-no_number = { $name } = { $given } n'est pas un nombre.

setting-needs_positions = { OPTION($name) } a besoin de positions.

setting-not_finite = { $name } = { $given } n'est pas un nombre fini.

setting-too_small = { $name } = { $given } est trop petit ; minimum { $least }.

setting-too_large = { $name } = { $given } est trop grand ; maximum { $most }.

setting-not_one_of = { $name } = { $given } n'est pas une valeur possible.

setting-value_count = { $name } = { $given } : { $n } valeurs sont nécessaires.

setting-wrong_type = { $name } = { $given } n'est pas du type { $type }.

setting-no_whole_number = { $name } = { $given } n'est pas un nombre entier.

setting-no_path = { $name } est un objet de type { $type }, pas un chemin.
