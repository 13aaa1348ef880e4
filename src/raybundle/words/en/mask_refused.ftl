# $n = 2
# $ids = ["a.jpg", "b.jpg"]
mask_refused = The { $n ->
        [one] mask
       *[other] masks
    } of { LIST($ids, most: 3) } cannot be used; { $n ->
        [one] the photograph is
       *[other] the photographs are
    } used completely.
