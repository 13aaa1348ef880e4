photograph_list-rules = Rules

# $name = "IMG_1.jpg"
photograph_list-taken = taken: { $name }

# $view = "above"
# $scale = 200
photograph_list-view = { $view ->
        [above] from above (Y up)
        *[front] from the front (Z up)
    }, 1 : { $scale }

# $n = 3
photograph_list-in_other_sketch = { $n } more in the other sketch

# $assistant = "Calibration"
# $name = "box"
photograph_list-title = { $assistant } of { $name }

# $n = 24
photograph_list-photographs = { $n } { $n ->
        [one] photograph
        *[other] photographs
    }

# $name = "target"
photograph_list-table_head = { $name ->
        [target] target
        [dot] dot, mm
        [code] code, mm
        *[photographs] photographs
    }

# $x = 1.5
# $y = -2.0
# $height = 1.7
photograph_list-stand = Stand at X { NUM($x, decimals: 2) }, Y { NUM($y, decimals: 2) } m, { NUM($height, decimals: 2) } m high.

# $distance = 3.2
# $tilt_deg = 12.0
# $up = true
photograph_list-aim = Distance to the object { NUM($distance, decimals: 2) } m, { NUM($tilt_deg, decimals: 0) } deg { $up ->
        [yes] up
        *[no] down
    }.

# $turn_deg = 30.0
# $clockwise = false
photograph_list-turned = Camera turned { NUM($turn_deg, decimals: 0) } deg { $clockwise ->
        [yes] clockwise
        *[no] anticlockwise
    }.

# $landscape = true
# $turn = 90
photograph_list-held = { $landscape ->
        [yes] Landscape
        *[no] Portrait
    } format{ $turn ->
        [0] {""}
        [180] , camera upside down
        [90] , camera turned 90 deg anticlockwise
        *[other] , camera turned 90 deg clockwise
    }.

# $width_px = 6000
# $height_px = 4000
# $pixel_um = 3.9
# $c_mm = 24.0
# $f_number = 8.0
photograph_list-camera = Camera { $width_px } x { $height_px } px of { NUM($pixel_um) } um, c = { NUM($c_mm, digits: 4) } mm, f/{ NUM($f_number) }.

# $focus_m = 2.5
photograph_list-focus = Focused to { NUM($focus_m) } m.

# $near_m = 1.2
# $far_m = 4.5
photograph_list-sharp = Sharp from { NUM($near_m) } m{ $far_m ->
        [0] {" "}on
        *[other] {" "}to { NUM($far_m) } m
    }.

# $sigma_px = 0.1
# $worst_mm = 0.4
# $mean_mm = 0.2
photograph_list-promise = Expected standard deviation of a coordinate, with { NUM($sigma_px) } px of image points: worst { NUM($worst_mm, digits: 2) } mm, mean { NUM($mean_mm, digits: 2) } mm.

# $share = 0.12
photograph_list-unseen = { PERCENT($share) } % of the object is in less than two photographs (as roof or top).

# $sigma_px = 0.1
# $likely_px = 0.12
# $sure = 0.95
# $sure_px = 0.25
photograph_list-calibration = Calibrated with it: image points to { NUM($sigma_px, digits: 2) } px at worst over the format (standard deviation).
    .why = Expected error there { NUM($likely_px, digits: 2) } px; at most { NUM($sure_px, digits: 2) } px with { PERCENT($sure) } %.

# $grade = "good"
# $limit_px = 0.5
photograph_list-use = { $grade ->
        [good] Good: hold it in other work with targets.
        [usable] Usable: hold it for natural points; targets require { NUM($limit_px) } px.
        *[weak] Weak: for these photographs alone, a start for others ({ NUM($limit_px) } px required).
    }

# $share = 0.8
photograph_list-reach = Image points reach { PERCENT($share) } % of the way to the corners.

# $n = 6
# $oriented = 5
# $missing = 1
# $beside = 0
photograph_list-ticked = List of { $n } photographs: { $oriented } oriented; { $missing } missing, { $beside } beside the list.

# $number = "05"
# $text = "front, left"
photograph_list-missing = Missing { $number }: { $text }

# $kind = "doubled"
# $names = ["03"]
photograph_list-named = { $kind ->
        [doubled] Taken more than once
        [rolled] Camera not held as listed
        [beside] Beside the list
        *[not_oriented] Not oriented
    }: { $names }.
