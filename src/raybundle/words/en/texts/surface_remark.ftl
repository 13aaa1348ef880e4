# $system = "EPSG:32633"
surface_remark-heights_relative = Heights in { $system } are relative: the control has no measured heights.

# $n = 1200
# $share = 0.03
# $x_min = -12.5
# $y_min = -8.0
# $x_max = 12.5
# $y_max = 8.0
surface_remark-outside = { $n } { $n ->
        [one] point
        *[other] points
    } ({ PERCENT($share) } %) { $n ->
        [one] lies
        *[other] lie
    } outside the area of the heights, that of the tie points.
    .do = Set { OPTION("extent", $x_min, $y_min, $x_max, $y_max) } to include all but 0.1 % at each edge.

# $n = 3
# $kinds = ["2 depths", "1 points"]
surface_remark-remade = { $n } { $n ->
        [one] product
        *[other] products
    } of earlier runs, damaged or missing, made anew: { LIST($kinds, most: 12) }.

# $memory_gb = 2.0
# $name = "a.jpg"
# $needed_gb = 2.6
surface_remark-memory = { OPTION("memory") } allows { NUM($memory_gb, digits: 2) } GB; the depth map of { $name } needs about { NUM($needed_gb, digits: 2) } GB.
    .why = Maps are made one at a time.

# $names = ["points.laz"]
surface_remark-earlier = { LIST($names, most: 12) }: of an earlier run, from the same points.

# $names = ["points.laz"]
# $length = 0.1
# $now = 0.0
# $setting = "las"
surface_remark-otherwise_thinned = { LIST($names, most: 12) }: of an earlier run, { $length ->
        [0] not thinned
        *[other] thinned by { NUM($length, digits: 12) }
    }; points.ply is { $now ->
        [0] not thinned
        *[other] thinned by { NUM($now, digits: 12) }
    }.
    .do = Write both alike with { OPTION($setting) }.

# $names = ["heights.tif"]
# $setting = "dsm"
surface_remark-removed = { LIST($names, most: 12) }: removed, because made from other points.
    .do = Write anew with { OPTION($setting) }.

# $cell = 0.01
# $density = 2
# $pixel = 0.004
# $least = 0.016
surface_remark-fine_cells = A cell of { NUM($cell) } is narrower than two point spacings ({ $density } × { NUM($pixel) } each); some have no height.
    .do = Set { OPTION("dsm", $least) } to fill most cells.

# $region = true
surface_remark-no_depth = No depth was found in it{ $region ->
        [yes] {" within the region"}
        *[no] {""}
    }.

# $share = 0.31
# $needed = 0.5
surface_remark-too_few_confirmed = Other depth maps confirm { PERCENT($share) } % of its depths; { PERCENT($needed) } % are needed.
