# $n = 2
# $ids = ["a.jpg", "b.jpg"]
mask_refused = The { $n ->
        [one] mask
       *[other] masks
    } of { LIST($ids, most: 3) } cannot be used; { $n ->
        [one] the photograph is
       *[other] the photographs are
    } used completely.
    .why = Features on the background may give wrong points in these photographs.
    .do = Correct the masks as described below, then run the command again.
