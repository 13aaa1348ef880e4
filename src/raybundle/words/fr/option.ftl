option-exclusive = { OPTION($first) } et { OPTION($second) } s'excluent.

option-missing = { OPTION($setting, $value) } manque.
