# $camera = "d5100"
# $c_mm = 28.1
# $parameter = "c"
# $source = "pairs"
# $n = 12
camera_constant = Camera { $camera }: the camera constant is not given; { NUM($c_mm, digits: 4) } mm is the approximate value.
    .why = It is from { $source ->
        [dlt] a DLT of control points ({ $n } values)
        [plane] control points in a plane ({ $n } values)
        [pairs] pairs of images ({ $n } values)
        [projective] a projective model of { $n } images
       *[format] the larger side of the format
     }.
    .do = Estimate { $parameter } unless it is known, and check it in the result.
