marks_left_out = { $n } points mesurés ne sont pas dans la compensation : { $names }.
