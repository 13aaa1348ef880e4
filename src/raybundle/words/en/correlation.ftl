correlation-contained = The standard deviations of the points contain this correlation.
    .why = It matters when the calibration is used for other photographs.

# $name = "d5100"
# $first = "x0"
# $second = "P1"
# $correlation = 0.98
# $roll = true
# $ids = ["d5100", "x0", "P1"]
correlation = Camera { $name }: { $first } and { $second } correlate by { NUM($correlation, decimals: 2) }.
    .do = { $roll ->
        [yes] No image is rolled by 90°: add two rolled images.
       *[no] { "" }
     }
