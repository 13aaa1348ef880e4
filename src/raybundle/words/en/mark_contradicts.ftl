# $point = "P12"
# $images = ["a.jpg"]
# $n = 1
# $tau = 7.4
# $size_px = 12.5
mark_contradicts = { $n ->
        [one] The mark of { $point } in { $images } contradicts the others{ $size_px ->
            [0] {""}
           *[other] {" "}by { NUM($size_px, digits: 2) } px
        }
       *[other] The marks of { $point } contradict each other: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(test value { NUM($tau, decimals: 1) }).
    }
    .why = It took part and distorts orientations, cameras and points.
    .do = Move or remove it, or exclude such marks: { OPTION("reject", "snooping") }.

# $point = "P12"
# $images = ["a.jpg"]
# $n = 1
# $tau = 7.4
# $size_px = 12.5
mark_contradicts-excluded = { $n ->
        [one] The mark of { $point } in { $images } contradicts the others{ $size_px ->
            [0] {""}
           *[other] {" "}by { NUM($size_px, digits: 2) } px
        }
       *[other] The marks of { $point } contradict each other: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(test value { NUM($tau, decimals: 1) }).
    }
    .why = It is excluded from the result.
    .do = Check the mark.
