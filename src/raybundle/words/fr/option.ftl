option-exclusive = { OPTION($first) } et { OPTION($second) } s'excluent.

option-missing = { OPTION($setting, $value) } manque.

option-needs = { OPTION($setting) } demande { OPTION($other) }.

option-one_of = Il faut exactement l'un de { OPTION($first) } et { OPTION($second) }.
