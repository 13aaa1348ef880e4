nominal_missing = { $n } point(s) nominaux n'ont pas été mesurés : { LIST($ids, most: 10) }.
