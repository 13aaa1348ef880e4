control_left_out = { $n } point(s) d'appui de { $name } contredisent les autres et sont exclus : { $ids }.
