# $n = 6
# $factor = 2.7
# $F = 7.27
# $p = 9.9e-08
# $scale_ppm = 120.0
# $sigma_ppm = 30.0
# $beyond = 1
# $ids = ["A1 - A2"]
lengths_contradict = Errors of { $n } check { $n ->
        [one] length
       *[other] lengths
     } are { NUM($factor, digits: 2) } times as large as stated (F { $F }, { P($p) }).
    .why = Standard deviations of points and deviations are too small by about this factor, or certificates are wrong.
    .do = Check the certificates of the check lengths and of the scale bars.

# $n = 6
# $factor = 2.7
# $F = 7.27
# $p = 9.9e-08
# $scale_ppm = 120.0
# $sigma_ppm = 30.0
# $beyond = 1
# $ids = ["A1 - A2"]
lengths_contradict-scale = Errors of { $n } check { $n ->
        [one] length
       *[other] lengths
     } are { NUM($factor, digits: 2) } times as large as stated (F { $F }, { P($p) }).
    .why = Standard deviations of points and deviations are too small by about this factor, or certificates are wrong.
    .do = Check the scale bars: measured lengths differ by { NUM($scale_ppm, digits: 2) } ± { NUM($sigma_ppm, digits: 2) } ppm.

# $n = 6
# $factor = 2.7
# $F = 7.27
# $p = 9.9e-08
# $scale_ppm = 120.0
# $sigma_ppm = 30.0
# $beyond = 1
# $ids = ["A1 - A2"]
# $length = "A1 - A2"
lengths_contradict-one = Errors of { $n } check { $n ->
        [one] length
       *[other] lengths
     } are { NUM($factor, digits: 2) } times as large as stated (F { $F }, { P($p) }).
    .why = Without { $length } the others agree.
    .do = Check the certificate and the end points of { $length }.

# $n = 1
# $factor = 2.7
# $F = 7.27
# $p = 9.9e-08
# $scale_ppm = 120.0
# $sigma_ppm = 30.0
# $beyond = 1
# $ids = ["A1 - A2"]
# $length = "A1 - A2"
lengths_contradict-single = Errors of { $n } check { $n ->
        [one] length
       *[other] lengths
     } are { NUM($factor, digits: 2) } times as large as stated (F { $F }, { P($p) }).
    .do = Check the certificate and the end points of { $length }, and the scale bars.

# $start = "A1"
# $end = "A2"
# $error_mm = 0.31
# $sigma_mm = 0.04
lengths_contradict-length = { $start } - { $end }: error { $error_mm } mm, sigma { NUM($sigma_mm, digits: 2) } mm.
