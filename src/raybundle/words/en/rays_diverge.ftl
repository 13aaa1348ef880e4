# $n = 2
# $ids = ["t1", "t2"]
rays_diverge = { $n } { $n ->
        [one] point with diverging rays was
       *[other] points with diverging rays were
     } left out: { $ids }.
    .why = The match is wrong, or the object is too far away for these stations; the other points are not affected.
    .do = Check these points in the photographs, or photograph from stations farther apart.
