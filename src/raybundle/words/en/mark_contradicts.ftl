# $point = "P12"
# $images = ["a.jpg"]
# $n = 1
# $tau = 7.4
# $size_px = 12.5
# $shift = 0.021
# $unit = "m"
mark_contradicts = The mark of { $point } in { $images } contradicts the others{ $size_px ->
        [0] {""}
       *[other] {" "}by { NUM($size_px, digits: 2) } px
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
# $shift = 0.021
# $unit = "m"
mark_contradicts-excluded = { $n ->
        [one] The mark of { $point } in { $images } contradicts the others{ $size_px ->
            [0] {""}
           *[other] {" "}by { NUM($size_px, digits: 2) } px
        }
       *[other] The marks of { $point } contradict each other: { $images }
    }{ $tau ->
        [0] .
       *[other] {" "}(test value { NUM($tau, decimals: 1) }){ $shift ->
            [0] .
           *[other] ; effect { NUM($shift, digits: 2) } { $unit }.
        }
    }
    .why = It is excluded from the result, in which the point stands without this effect.
    .do = Check the mark.

# $point = "P12"
# $images = ["a.jpg", "b.jpg", "c.jpg"]
# $n = 3
# $tau = 7.4
# $size_px = 0
# $shift = 0.021
# $unit = "m"
mark_contradicts-undecided = The { $n } marks of { $point } contradict each other: { LIST($images, most: 3) }{ $shift ->
        [0] .
       *[other] ; effect up to { NUM($shift, digits: 2) } { $unit }.
    }
    .why = Which one is wrong is not determinable: all took part with standard deviations under which they agree.
    .do = Check these marks, the first one first, or measure the point in another photograph.
