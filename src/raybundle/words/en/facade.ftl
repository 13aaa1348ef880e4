# $kind = "vertical"
# $n = 412
# $of = 1036
# $back = -0.35
# $front = 0.62
# $unit = "m"
facade-wall = Wall: { $kind ->
        [vertical] plumb
        [horizontal] level
        *[other] best-fitting
    } plane of { $n } of { $of } points, relief from { NUM($back, digits: 2) } to { NUM($front, digits: 2) } { $unit }.

# $width = 4210
# $height = 2980
# $pixel = 0.005
# $unit = "m"
facade-picture = True orthophoto: { $width } x { $height } px of { $pixel } { $unit }.

# $share = 0.91
# $filled = 0.06
# $white = 0.03
facade-coverage = Pixels: { PERCENT($share) } % on measured heights, { PERCENT($filled) } % filled, { PERCENT($white) } % white.

# $sigma = 3.4
# $unit = "mm"
facade-place_sigma = Standard deviation of the place of a pixel: { NUM($sigma, digits: 2) } { $unit } (median).

facade-no_scale = The scale is not determined: no sheet and no drawing are written.
    .do = Give orient a scale bar ({ OPTION("scale_bar", "A", "B", "LENGTH", "SIGMA") }), two control points or positions; then repeat.
