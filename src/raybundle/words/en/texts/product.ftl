# $n = 1200
# $system = "EPSG:32633"
# $step = 0.0001
product-las = { $n } { $n ->
        [one] point
        *[other] points
    } in { $system ->
        [none] the axes of the block
        *[other] { $system }
    }, in steps of { $step }.

product-las_without_unit = The scale is free: coordinates and standard deviations have no unit, which LAS cannot state.

product-lazrs_missing = LAZ needs lazrs, which is not installed; uncompressed LAS is written.
    .do = pip install 'raybundle[las]'

# $vertices = 12000
# $triangles = 24000
# $sigma = 0.8
# $unit = "mm"
product-mesh = { $vertices } vertices, { $triangles } triangles; median standard deviation of a height { NUM($sigma, digits: 2) } { $unit }.

# $width = 1200
# $height = 800
# $cell = 0.01
# $unit = "m"
# $share = 0.92
# $sigma = 0.8
# $sigma_unit = "mm"
product-heights = { NUM($width, decimals: 0) } x { NUM($height, decimals: 0) } cells of { NUM($cell, digits: 6) } { $unit }, { PERCENT($share) } % with a height; median standard deviation { NUM($sigma, digits: 2) } { $sigma_unit }.

# $width = 12000
# $height = 8000
# $pixel = 0.002
# $unit = "m"
product-orthophoto_unseen = { $width } x { $height } px of { NUM($pixel, digits: 6) } { $unit }, none of them visible.

# $width = 12000
# $height = 8000
# $pixel = 0.002
# $unit = "m"
# $share = 0.92
# $photographs = 12
product-orthophoto = { $width } x { $height } px of { NUM($pixel, digits: 6) } { $unit }, { PERCENT($share) } % of them visible in { $photographs } { $photographs ->
        [one] photograph
        *[other] photographs
    }.

# $median = 0.8
# $most = 2.4
# $unit = "mm"
# $beyond = 0.012
product-orthophoto_sigma = Standard deviation in plan: median { NUM($median, digits: 2) } { $unit }, 95 % below { NUM($most, digits: 2) } { $unit }.
    .why = It exceeds a pixel at { PERCENT($beyond) } % of the places.

# $share = 0.7
# $coarse = true
product-orthophoto_gaps = { PERCENT($share) } % of the cells of its heights were measured; small gaps are closed.
    .why = Beyond these, no pixel is visible.
    .do = { $coarse ->
        [yes] A finer { OPTION("density") } may fill some of the others.
        *[no] {""}
    }

product-orthophoto_scenes = Grey values of scenes are stretched to 8 bits: their radiometry is lost.
