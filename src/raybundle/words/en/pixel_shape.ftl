# $camera = "d5100"
# $symbol = "A"
# $shear = false
# $found = 0.003
# $sigma = 0.0001
# $limit = 0.0001
# $ids = ["d5100", "A"]
pixel_shape = Camera { $camera }: { $shear ->
        [yes] shear
       *[no] affinity
     } { $symbol } of { NUM($found, digits: 2) } ± { NUM($sigma, digits: 1) } is impossible for a sensor (limit { NUM($limit, digits: 1) }).
    .why = It is held; motion during read-out, edges shifted by uneven light, or weak geometry may cause it, and standard deviations may be too small.
    .do = For a scan or an old camera, adjust again with this parameter in { OPTION("free") } (raybundle adjust).
