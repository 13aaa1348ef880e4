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
nominal_scale = Nominal and measured points differ in scale by { $near_1 ->
        [yes] { NUM($scale_ppm, digits: 4) } ppm
       *[no] a factor of { NUM($factor, digits: 6) }
     }.
    .why = They fit to { NUM($rms_mm, digits: 2) } mm rms with this scale and to { NUM($rms_same_scale_mm, digits: 2) } mm without.
    .do = Check the unit of the file and the scale bars.
