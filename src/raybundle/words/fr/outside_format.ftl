outside_format = { $n } point(s) image hors du format de { $ids }.
