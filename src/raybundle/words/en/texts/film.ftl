# $scans = 3
# $points = 24
# $rms_um = 6.0
film-transformed = Film: { $scans } { $scans ->
        [one] scan
        *[other] scans
    } transformed, rms of fiducial marks at most { NUM($rms_um, digits: 2) } um, { $points } image points.
