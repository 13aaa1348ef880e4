# $n = 1
# $ids = ["M1-M2"]
scale_unchecked = The scale rests on { $n ->
        [one] one scale bar
       *[other] { $n } scale bars
     } ({ $ids }); no independent length confirms it.
    .why = { $n ->
        [one] If its length is wrong, every length is wrong by the same factor and no residual shows it.
       *[other] If one of these lengths is wrong, other lengths are wrong as well and no residual shows it.
     }
    .do = Add a second scale bar, or a measured length between two points.
