# $name = "d5100"
# $symbol = "c"
# $sigma = 1.2
# $unit = "mm"
# $remedy = "converge"
# $ids = ["d5100", "c"]
not_determinable = Camera { $name }: { $symbol } is not determinable (standard deviation { NUM($sigma, digits: 2) } { $unit }).
    .why = The photographs determine it less precisely than it is known beforehand.
    .do = { $remedy ->
        [converge] Hold it, or add images that converge by 45° or more, or points at different depths.
        [roll] Add two images rolled by 90°.
        [views] Hold it, or add convergent images.
       *[corners] Hold it, or measure points up to the corners of the format.
     }
