record-unknown_entry = Le procès-verbal n'a pas une telle entrée.

record-not_a_text = Une entrée du procès-verbal est un texte.

record-too_long = L'entrée { $name } du procès-verbal a { $n } caractères ; { $most } au plus sont possibles.
