geo_txt-empty = Le fichier est vide.

geo_txt-name_is_number = { $value } est un nombre ; la première colonne est le nom d'une photographie.
