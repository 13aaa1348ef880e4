# $width = 4000
# $height = 3000
# $pixel = 0.002
# $unit = "m"
# $share = 0.97
# $n = 8
picture-rectified = Rectified: { $width } x { $height } px of { $pixel } { $unit }, { PERCENT($share) } % covered from { $n } { $n ->
        [one] photograph
        *[other] photographs
    }.

# $kind = "free"
# $n = 120
# $of = 140
# $rms = 0.004
# $unit = "m"
picture-plane = { $kind ->
        [plumb] Plumb plane
        [vertical] Vertical plane
        [horizontal] Level plane
        *[other] Plane
    } of { $n } of { $of } points{ $kind ->
        [plumb] {""}
        *[other] ; rms distance from it { NUM($rms, digits: 2) } { $unit }
    }.

# $slope = 0.4
# $largest = 1.1
picture-displacement = Relief displacement: { NUM($slope, digits: 2) } of the distance from the plane (rms; at most { NUM($largest, digits: 2) }).

# $lean = "0.2 degrees forward"
# $vertical = "Z of the block"
picture-lean = The points lean { $lean } (vertical: { $vertical }).

# $height = 103.25
picture-level = Height of the level: { NUM($height, decimals: 2) }.

# $sigma0 = 0.92
# $sigma_px = 0.5
# $redundancy = 4
picture-sigma0 = sigma0 { NUM($sigma0, digits: 2) } (marks { $sigma_px } px a priori), redundancy { $redundancy }.

# $rms = 0.003
picture-points_off_plane = Distance of the control points from their plane: { NUM($rms, digits: 2) } (rms).

picture-differences = Measured minus given coordinates:

# $share = 0.12
# $distance_share = 0.02
picture-before_plane = { PERCENT($share) } % of the picture shows objects before the plane, displaced in the picture.
    .why = These, such as trees or another wall, are nearer by more than { PERCENT($distance_share) } % of the distance, and no photograph looks past them.
    .do = Exclude them by a smaller { OPTION("extent") }, or choose photographs by { OPTION("only") }.

picture-axes_given = The picture has the given axes, not those of the map.

# $system = "EPSG:4326"
picture-local_plane = { $system } is no projected system; the picture is in the local plane of the block, east to the right.

# $system = "EPSG:32633"
picture-in_map = The picture is in { $system }.
