# $point = "P1"
# $image = "IMG_1"
# $off_px = 120.0
# $limit_px = 15.0
# $hint = "none"
# $other = "P2"
# $other_px = 0.4
# $ids = ["P1", "IMG_1"]
mark_rejected = The measurement of point { $point } in { $image } is { NUM($off_px, decimals: 0) } px off the others and left out.
    .why = The limit is { NUM($limit_px, digits: 4) } px{ $hint ->
     [same_place] ; point { $other } is measured at the same place
     [near] ; it is { NUM($other_px, digits: 2) } px from point { $other }
     *[none] { "" }
    }.
    .do = Check its name, and measure it again.

# $point = "P1"
# $image = "IMG_1"
# $kind = "blunder"
# $tested = true
# $tau = 6.1
# $limit = 4.2
# $ids = ["P1", "IMG_1"]
mark_rejected-test = The measurement of point { $point } in { $image } contradicts the others and is left out.
    .why = { $kind ->
     [behind_camera] The point is behind the camera.
     [rays_diverge] The rays of the point diverge.
     [single_ray] The other rays of the point were rejected.
     [given] It is excluded in the given observations.
     [blunder_not_located] One of the rays of the point is a blunder; which one is ambiguous.
     *[other] It is a blunder.
    }{ $tested ->
     [yes] { "" } Test value { NUM($tau, decimals: 2) }, limit { NUM($limit, decimals: 2) }.
     *[no] { "" }
    }
    .do = Measure it again.
