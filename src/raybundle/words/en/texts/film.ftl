# $scans = 3
# $points = 24
# $rms_um = 6.0
film-transformed = Film: { $scans } { $scans ->
        [one] scan
        *[other] scans
    } transformed, rms of fiducial marks at most { NUM($rms_um, digits: 2) } um, { $points } image points.

# $n = 3
# $largest_um = 0.4
film-distortion_terms = K1 to K{ $n } represent the distortion table to { NUM($largest_um, decimals: 2) } µm.

# $difference_um = 12.0
# $corner_um = 3.5
film-principal_points_differ = The principal points differ by { NUM($difference_um, decimals: 0) } µm.
    .why = The part that the exterior orientation does not absorb is at most { NUM($corner_um, decimals: 1) } µm in the corners.
