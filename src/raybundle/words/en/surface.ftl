# $n = 812345
# $maps = 11
surface-points = Surface: { $n } points from { $maps } { $maps ->
        [one] depth map
        *[other] depth maps
    }.

# $median = 0.84
# $unit = "mm"
# $free_scale = false
surface-precision = Standard deviation of a point: { NUM($median, digits: 2) } { $free_scale ->
        [yes] units (median, scale arbitrary)
        *[no] { $unit } (median)
    }.

# $x = 0.4
# $y = 0.4
# $z = 0.7
# $along_ray = 0.6
# $unit = "mm"
surface-precision_of_axes = Median standard deviation: X { $x }, Y { $y }, Z { $z }, along the ray { $along_ray } { $unit }.

# $noise = 60
# $roughness = 30
# $orientation = 10
surface-shares = Variance along the ray: noise { $noise } %, roughness { $roughness } %, orientation { $orientation } %.

# $setting = "plane"
surface-plane_without_heights = { OPTION($setting) } belongs to a height grid; none is requested.
    .do = Give { OPTION("dsm", "CELL") }, { OPTION("ortho", "CELL") }, { OPTION("mesh", "CELL") }, or { OPTION("region") }.

# $name = "notes.txt"
surface-foreign_file = The folder contains { $name }, which is not part of a surface.
    .do = Choose another { OPTION("out") }.

surface-no_point_above_area = No point of the surface is above the area of the heights.
    .do = Choose another area.

surface-scale_free = The scale of the block is not determined, so a surface has no unit of length.
    .do = Adjust with a scale bar, two control points or observed positions, or give { OPTION("free_scale", "True") }.

# $side = 0.5
surface-mesh_empty = No triangle of side { $side } has heights at all corners.
    .do = Choose another area or { OPTION("mesh") }.

# $width = 0.02
# $height = 0.05
# $apart = 0.1
surface-region_too_small = The region of { $width } x { $height } is smaller than the point spacing of { $apart }.
    .do = Give a larger region, or another { OPTION("density") }.

# $given = "0 0, 10 5"
# $rectangle = true
surface-region_not_readable = { OPTION("region", $given) } is neither a file nor three corners or more.
    .do = { $rectangle ->
        [yes] Give a rectangle as { OPTION("extent") }, or corners as X Y, X Y, X Y
       *[no] Give corners as X Y, X Y, X Y
    }.

# $side = 0.0001
# $most = 1000000000000000.0
# $least = 0.01
surface-too_many_cubes = { OPTION("thin", $side) } divides the surface into more than { $most } cubes.
    .do = Give more than { NUM($least, digits: 2) }.

surface-orthophoto_not_shown = No photograph shows the area of the orthophoto.
    .do = Choose another area.

# $left = 0.0
# $right = 10.0
# $bottom = 0.0
# $top = 5.0
surface-region_not_shown = No photograph that measures depths shows the region.
    .why = It is { NUM($left, digits: 10) } to { NUM($right, digits: 10) } and { NUM($bottom, digits: 10) } to { NUM($top, digits: 10) } in the plane.
    .do = Give another region.

surface-no_pair = No two photographs can measure depths.
    .do = Add photographs that show the same part of the object from different places.

# $n = 1
# $least = 2
surface-too_few_photographs = { $n } { $n ->
        [one] photograph of the result is
       *[other] photographs of the result are
    } available; a surface needs { $least }.
    .do = Give the folder of the photographs: { OPTION("photos", "FOLDER") }.

# $n = 2
# $photographs = 12
surface-photographs_lost = { $n } of { $photographs } adjusted photographs cannot be used.
    .why = The surface has gaps where only they show it.
    .do = Give their folder with { OPTION("photos", "FOLDER") }.

# $share = 0.012
# $pixels = 120000
# $region = false
surface-nothing_measured = Nothing was measured{ $region ->
        [yes] {" "}in the region
       *[no] {""}
    }: { PERCENT($share) } % of { $pixels } pixels have a depth, none confirmed.
    .why = Sky, water, glass, plain walls and moving objects have no stable texture.
    .do = Take photographs of textured surfaces with 60 % overlap or more.

# $given = "area.geojson"
surface-region_invalid = { OPTION("region", $given) } is not a valid region.
    .do = Give the corners in order, without crossing edges.

surface-no_depth_map = No depth map could be computed.
    .do = Correct the cause below, then run surface again.

# $share = 0.012
# $pixels = 120000
# $region = false
surface-other_photographs = Nothing was measured{ $region ->
        [yes] {" "}in the region
       *[no] {""}
    }: photographs differ from those that were oriented.
    .why = { PERCENT($share) } % of { $pixels } pixels have a depth, unconfirmed by other photographs.
    .do = Give the photographs that were oriented: { OPTION("photos", "FOLDER") }, or orient the present ones again.

# $n = 2
# $names = ["a.jpg", "b.jpg"]
surface-photographs_replaced = { $n } { $n ->
        [one] photograph is not the file that was
        *[other] photographs are not the files that were
    } oriented: { $names }.
    .why = Depths are wrong or missing where pixels differ.
    .do = Restore the original files.

# $n = 2
# $names = ["a.jpg: b.jpg", "b.jpg: a.jpg"]
surface-photographs_exchanged = { $n } { $n ->
        [one] photograph contains
        *[other] photographs contain
    } the picture of another one (file: picture): { $names }.
    .why = These photographs are used with a wrong orientation, so depths are wrong.
    .do = Give the files their original names, then run surface again.
