# $first = "after"
# $second = "before"
# $n = 12
# $agree = 5
# $rms_mm = 0.31
# $rms_same_scale_mm = 2.4
# $factor = 1.0012
# $factor_sigma = 2e-05
# $scale_ppm = 1200.0
# $sigma_ppm = 20.0
# $near_1 = true
# $units = ""
# $sigmas = 8.2
# $bars = ["B1", "B2"]
# $ids = ["after", "before"]
epochs_scale = Epochs { $first } and { $second } differ in scale by { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] a factor of { NUM($factor, digits: 6) }
     }.
    .why = This is { $sigmas } standard deviations of their scales; the scale is now free, so a uniform expansion is not detected.
    .do = Check the scale bars of both epochs: { $bars }.
