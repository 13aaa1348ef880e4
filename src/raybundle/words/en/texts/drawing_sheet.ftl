# $at_point = true
# $origin = "A"
# $right = "points"
# $first = "A"
# $second = "B"
drawing_sheet-axes = origin { $at_point ->
        [yes] at { $origin }
        *[no] in the middle of the points
    }, right { $right ->
        [points] from { $first } towards { $second }
        [block] along the block's X and Y
        *[level] level
    }

drawing_sheet-beside = Points off the plane, beside their image in the picture (rms over the photographs):

# $n = 3
drawing_sheet-beside_more = { $n } more { $n ->
        [one] point
        *[other] points
    }.

# $name = "P1"
# $off_mm = 12.0
drawing_sheet-beside_point = { $name }: { NUM($off_mm, digits: 2) } mm.

# $name = "client"
drawing_sheet-field = { $name }

# $kind = "control"
drawing_sheet-kind = { $kind ->
        [control] control point
        [check] check point
        [point] measured point
        [tie] tie point
        [distance] distance
        [plumb_line] plumb line
        [level] level
        [straight_line] straight line
        *[plane] plane
    }

# $back = true
# $angle_deg = 1.2
# $known = true
# $sigma_deg = 0.3
drawing_sheet-lean = Its points lean { $back ->
        [yes] back
        *[no] forward
    } by { NUM($angle_deg, digits: 2) }{ $known ->
        [yes] {" "}± { NUM($sigma_deg, digits: 2) }
        *[no] {""}
    } degrees.

drawing_sheet-lengths = Lengths at their lines are lengths in space.

# $system = "EPSG:25832"
# $named = true
# $name = "ETRS89 / UTM zone 32N"
# $level = true
# $height = 212.5
drawing_sheet-map = { $system }{ $named ->
        [yes] {" "}({ $name })
        *[no] {""}
    }{ $level ->
        [yes] , level ground at height { NUM($height, decimals: 2) }
        *[no] {""}
    }

# $slope = 0.31
drawing_sheet-moved = Points off the plane are displaced in the picture by { NUM($slope, decimals: 2) } of their distance from it (rms).

# $number = 2
drawing_sheet-other_sheet = sheet { $number }

# $name = "A3"
# $landscape = true
drawing_sheet-paper = { $name } { $landscape ->
        [yes] landscape
        *[no] portrait
    }

# $sizes_mm = [5.0]
# $pictures = 1
# $n = 12
drawing_sheet-pixel = Pixel of the { $pictures ->
        [one] picture
        *[other] pictures
    }: { LIST($sizes_mm, most: 5) } mm{ $n ->
        [0] {""}
        [one] , from { $n } photograph
        *[other] , from { $n } photographs
    }.

# $kind = "vertical"
# $n = 12
# $known = true
# $rms = 0.004
# $unit = "m"
drawing_sheet-plane = { $kind ->
        [vertical] Plumb
        [horizontal] Level
        *[other] Best-fitting
    } plane by { $n } { $n ->
        [one] point
        *[other] points
    }{ $known ->
        [yes] , { NUM($rms, digits: 2) } { $unit } off it (rms)
        *[no] {""}
    }.

# $more = true
drawing_sheet-plane_axes = of the plane: X right, Y up{ $more ->
        [yes] ;
        *[no] {""}
    }

# $n = 22
# $map = false
# $x_mm = 0.4
# $y_mm = 0.5
# $z_mm = 1.1
drawing_sheet-precision = Standard deviation of { $n } named { $n ->
        [one] point
        *[other] points
    } (rms): { $map ->
        [yes] E
        *[no] X
    } { NUM($x_mm, digits: 2) } mm, { $map ->
        [yes] N
        *[no] Y
    } { NUM($y_mm, digits: 2) } mm, { $map ->
        [yes] height
        *[no] across the plane
    } { NUM($z_mm, digits: 2) } mm.

drawing_sheet-vertical = Vertical:

# $scale = 50
# $paper = "A2 landscape"
# $n = 2
# $columns = 2
# $rows = 1
drawing_sheet-sheets = Drawn: 1 : { $scale } on { $paper }, { $n } { $n ->
        [one] sheet
        *[other] sheets ({ $columns } x { $rows })
    }.

# $pictures = 1
# $points = 12
# $lines = 3
drawing_sheet-content = Content: pictures { $pictures }, points { $points }, lines { $lines }.

# $block = "wall"
# $other = "roof"
drawing_sheet-other_block = The picture belongs to block { $block }, the points to { $other }.

drawing_sheet-metres_assumed = The unit of the picture is unknown; metres are assumed.

# $names = ["client", "place"]
drawing_sheet-shortened = Shortened in the title block: { LIST($names, most: 12) }.

# $letters = ["א", "字"]
drawing_sheet-letters = Letters that a sheet cannot show are printed as question marks: { LIST($letters, most: 10) }.

# $share = 0.91
# $filled = 0.06
# $white = 0.03
drawing_sheet-true_orthophoto = True orthophoto: { PERCENT($share) } % on measured heights, { PERCENT($filled) } % filled, { PERCENT($white) } % seen by no photograph.

# $sigma_mm = 3.4
drawing_sheet-place_sigma = Standard deviation of the place of a measured pixel: { NUM($sigma_mm, digits: 2) } mm (median).
