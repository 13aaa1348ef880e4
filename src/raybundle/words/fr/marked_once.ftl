marked_once = { $n } point(s) mesuré(s) dans une seule photographie et non déterminé(s) : { $ids }.
