# $n = 812345
# $maps = 11
surface-points = Surface: { $n } points from { $maps } { $maps ->
        [one] depth map
        *[other] depth maps
    }.

# $n = 2
# $of = 11
# $names = ["a.jpg", "b.jpg"]
surface-photographs_missing = { $n } of { $of } adjusted photographs cannot be used: { $names }.
    .why = The surface has gaps where only they show it.
    .do = Give their folder with { OPTION("photos", "FOLDER") }.

surface-other_photographs = Photographs are not the files that were oriented.
    .why = Depths are wrong or missing where the pixels differ.
    .do = Restore the original files and names.

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
