setting-unknown = Le réglage { $name } est inconnu.

setting-wrong_kind = { $name } = { $given } n'est pas possible.

setting-several_values = { $name } = { $given } n'est pas une valeur unique.

setting-quotation_open = { $name } = { $given } : un guillemet n'est pas fermé.

setting-impossible_character = { $name } = { $given } contient un caractère impossible dans un nom de fichier.

setting-word_count = { $name } = { $given } n'a pas la forme { $form }.

setting-no_text = { $name } = { $given } n'est pas un texte.

setting-no_number = { $name } = { $given } n'est pas un nombre.

setting-needs_positions = { OPTION($name) } a besoin de positions.
