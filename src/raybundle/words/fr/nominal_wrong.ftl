nominal_wrong = { $wrong } point(s) s'écartent du nominal bien plus que les autres : { $ids }.
