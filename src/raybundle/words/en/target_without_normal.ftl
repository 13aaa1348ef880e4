# $n = 2
# $ids = ["7", "8"]
target_without_normal = { $n } round { $n ->
     [one] target is
     *[other] targets are
    } not corrected for eccentricity, as the normal is unknown: { $ids }.
    .do = Give the columns nX, nY, nZ, or four targets in one plane.
