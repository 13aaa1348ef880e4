# $name = "d5100"
# $dated = true
# $date = "2026-05-01"
# $observed = true
# $poor = false
# $grade = "good"
camera_library-taken = Calibration { $name } of the camera library{ $dated ->
        [yes] , of { $date },
        *[no] {""}
    } is { $observed ->
        [yes] observed with its covariance
        *[no] held: its covariance is not known
    }{ $poor ->
        [yes] ; grade: { $grade ->
            [not_determinable] not determinable
            *[other] { $grade }
        }
        *[no] {""}
    }.
    .do = Estimate it anew where it is wrong: { OPTION("library", "False", flag: "no-library") }.
