# $n = 2
# $ids = ["a.jpg", "b.jpg"]
mask_uniform = The { $n ->
        [one] mask
       *[other] masks
    } of { $n } { $n ->
        [one] photograph hides
       *[other] photographs hide
    } nothing: { LIST($ids, most: 3) }.
    .why = A mask hides where every channel is 0, or where a varying alpha channel is 0.
    .do = Check the masks.

# $n = 2
# $ids = ["a.jpg", "b.jpg"]
mask_uniform-hidden = { $n } { $n ->
        [one] photograph is
       *[other] photographs are
    } hidden completely by { $n ->
        [one] its mask
       *[other] their masks
    }: { LIST($ids, most: 3) }.
    .why = Nothing is measured there. A mask hides where every channel is 0, or where a varying alpha channel is 0.
    .do = Check whether the masks are inverted.
