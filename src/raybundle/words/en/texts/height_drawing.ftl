# $n = 2
height_drawing-regions_moved = { $n ->
        [0] No region has moved significantly against the rest
        [one] 1 region has moved significantly against the rest
        *[other] { $n } regions have moved significantly against the rest
    }

# $unit = "m"
# $upright = true
height_drawing-movement = Movement against the rest { $unit ->
        [none] (no unit: the scale is free)
        *[other] [{ $unit }]
    }: + (red) { $upright ->
        [yes] up, - (blue) down
        *[no] towards the viewer, - (blue) away
    }

# $state = "moved"
height_drawing-swatch = { $state ->
        [moved] outlined: significant movement
        [chance] pale: not significant
        *[unknown] hatched: no height in both
    }

# $unit = "m"
# $movements = ["0.003 (0.1 x 0.1)", "0.001 (0.5 x 0.5)"]
height_drawing-smallest_movements = Found with a probability of 80 %, median over the surface { $unit ->
        [none] (no unit: the scale is free)
        *[other] [{ $unit }]
    }: { LIST($movements, most: 8) }

# $name = "section 1"
height_drawing-no_height = { $name }: no height along it

# $axis = "distance"
# $unit = "m"
height_drawing-axis = { $axis ->
        [distance] distance
        *[height] height
    } { $unit ->
        [none] (no unit: the scale is free)
        *[other] [{ $unit }]
    }

# $factor = 2
# $stretch = 5.0
height_drawing-band = band: { $factor } sigma{ $stretch ->
        [0] {""}
        *[other] ; heights { $stretch } times as large as distances
    }

# $left = 10.5
# $top = 20.25
# $width = 12.0
# $interval = 0.1
# $unit = "m"
height_drawing-contours = left { NUM($left, digits: 10) }, top { NUM($top, digits: 10) }, width { NUM($width, digits: 6) }, interval { NUM($interval, digits: 6) } { $unit ->
        [none] (no unit: the scale is free)
        *[other] { $unit }
    }

# $n = 2
# $total = 3
height_drawing-volumes = band: 95 %; significant changes: { $n } of { $total }

# $unit = "m"
height_drawing-axis_volume = volume { $unit ->
        [none] (no unit: the scale is free)
        *[other] [{ $unit }3]
    }

# $side = 0.5
# $unit = "m"
height_drawing-detectable = Smallest detectable movement (80 % power) over { $side } x { $side } { $unit ->
        [none] (no unit: the scale is free)
        *[other] { $unit }
    }

# $state = "unknown"
height_drawing-detectable_swatch = { $state ->
        [unknown] grey: not known for this size
        *[untested] hatched: not tested, no height in both
    }
