

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

# $assistant = "calibration"
# $name = "box"
photograph_list-title = { $assistant ->
        [calibration] Calibration photographs
        [cipa] CIPA photographs
        [turntable] Turntable photographs
        *[targets] Photographs of targets
    } of { $name }

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

# $title = "CIPA photographs of box 12 x 8 x 6 m"
# $n = 15
# $of = 16
photograph_list-title_taken = { $title }: { $n } of { $of } taken

# $n = 2
# $names = ["03", "07"]
photograph_list-missing = { $n ->
        [0] Missing: none
        *[other] Missing: { LIST($names, most: 1000) }
    }

photograph_list-convergent = 1 convergent, full format

photograph_list-square = 2 square, sheet in the corners

photograph_list-farther = 3 from farther away

# $azimuth_deg = 45
photograph_list-whole_sheet = Whole sheet from { $azimuth_deg } deg round it.

photograph_list-sheet_in_corner = Sheet in another corner of the format.

# $side = "front"
photograph_list-sheet_from = Sheet from the { $side ->
        [front] front
        [right] right
        [back] back
        *[left] left
    }.

photograph_list-rule_fixed_lens = Set and tape zoom, focus and aperture. Switch off autofocus, stabilisation and automatic rotation.

# $distance_m = 0.62
photograph_list-rule_sheet = The sheet fills the format at { NUM($distance_m, decimals: 2) } m. It is flat. Move the camera, or turn the sheet instead.

photograph_list-rule_every_corner = Over all photographs together every part of the format must show targets, also the corners.

photograph_list-rule_light = Use enough light for a short exposure, or a tripod. Avoid reflections.

# $near_m = 0.5
# $far_m = 0.8
# $first_m = 0.4
# $last_m = 0.9
photograph_list-sharp_limits = Sharp from { NUM($near_m, decimals: 2) } to { NUM($far_m, decimals: 2) } m; the sheet reaches from { NUM($first_m, decimals: 2) } to { NUM($last_m, decimals: 2) } m.

# $f_number = 20
# $focus_m = 0.6
photograph_list-stop_down = Stop down to f/{ $f_number } and focus to { NUM($focus_m, decimals: 2) } m.
    .do = Or take a larger sheet from farther away, or accept less precise, soft targets.

# $needed = 41
# $times = 2.5
# $width_m = 1.05
# $height_m = 0.75
# $distance_m = 1.6
# $focus_m = 1.4
# $f_number = 16.0
photograph_list-larger_sheet = All of it is sharp at f/{ $needed } only, beyond most lenses. A sheet { NUM($times, decimals: 1) } times as large is sharp.
    .why = { NUM($width_m, decimals: 2) } x { NUM($height_m, decimals: 2) } m from { NUM($distance_m, decimals: 2) } m, focused to { NUM($focus_m, decimals: 2) } m, at f/{ NUM($f_number, decimals: 0) }.

# $f_number = 16.0
# $focus_m = 0.6
# $near_m = 0.5
# $far_m = 0.8
# $blur_px = 2.4
# $sharp_px = 1.0
photograph_list-blurred_sheet = With this sheet, f/{ NUM($f_number, decimals: 0) } focused to { NUM($focus_m, decimals: 2) } m is sharp from { NUM($near_m, decimals: 2) } to { NUM($far_m, decimals: 2) } m.
    .why = Targets at its ends are blurred by { NUM($blur_px, decimals: 1) } px ({ $sharp_px } px is sharp): less precise, and lost where dots are hardly larger.

# $elevation_deg = 15.0
photograph_list-above_table = Camera { $elevation_deg } deg above the table

# $turn_deg = 45.0
photograph_list-table_turned = Table turned to { NUM($turn_deg, decimals: 0) } deg.

# $distance_m = 1.2
photograph_list-rule_turntable = The camera stands { NUM($distance_m, decimals: 2) } m before the middle of the object; only its height changes.

photograph_list-rule_background = Show only the object and its table: a fixed background contradicts the rest.
    .do = Use a plain one, or masks.

photograph_list-rule_even_light = Targets or texture on the table turn with the object and may be measured.
    .do = Use even light, for fixed light moves over them.

photograph_list-rule_scale = Scale: a bar, or two targets of known distance, on the table.

# $names = ["T1", "T2"]
photograph_list-targets_shown = Targets: { LIST($names, most: 1000) }

# $n = 40
# $dot_mm = 8.2
# $code_mm = 25.0
photograph_list-rule_targets = { $n } targets, codes 1 to { $n }: dots of { NUM($dot_mm, decimals: 1) } mm, codes { NUM($code_mm, decimals: 0) } mm across (the largest; the table has each).

# $number = 1
# $length_m = 3.25
# $start = "T1"
# $end = "T17"
# $sigma_mm = 0.05
photograph_list-rule_bar = Scale bar { $number }: { NUM($length_m, decimals: 3) } m between { $start } and { $end }, length known to { NUM($sigma_mm, digits: 2) } mm or better.

photograph_list-rule_flat = Fix targets flat, not over an edge and not hidden by another.
    .why = Places may deviate by a part of the distance between targets.

photograph_list-cipa_control = 1 Control: long distances between good points, at least one on every side.
    .why = Plumb lines and level lines.

photograph_list-cipa_ring = 2 Ring: photographs all round that overlap by more than half.
    .why = Views over every corner at 45 degrees.

photograph_list-cipa_details = 3 Details: square stereo pairs of every facade, base to distance 1:4 to 1:15.
    .why = Ornaments nearer still.

photograph_list-cipa_camera = 4 Camera: one camera, one lens; fixed zoom and focus, no automatic correction of the picture.

photograph_list-cipa_calibration = 5 Calibration: a lens calibrated before or with these photographs.
    .why = The widest good one; note both.

photograph_list-cipa_exposure = 6 Exposure: even light, small aperture, low sensitivity, a tripod where it is dark.
    .why = Raw or the best quality.

photograph_list-cipa_sketch = 7 Sketch: a ground plan with the stations and the direction north, an elevation of each side.

photograph_list-cipa_protocol = 8 Protocol: owner, place, date, weather, camera and lens, photographer, the distances of rule 1.

photograph_list-cipa_check = 9 Check: look through everything on site, sharp and complete; make a copy before leaving.

# $side = "right"
# $number = 0
# $more = false
photograph_list-side = { $number ->
        [0] { $side ->
            [front] front
            [right] right side
            [back] back
            *[left] left side
        }
        *[other] side { $number } ({ $side ->
            [front] front
            [right] right
            [back] back
            *[left] left
        })
    }{ $more ->
        [yes] ,
        *[no] {""}
    }

# $at_m = 3.2
photograph_list-along = { NUM($at_m, decimals: 1) } m from its left end, ground to top

photograph_list-ring = Ring:

photograph_list-corners = Ring: corners

# $turn_deg = 45.0
photograph_list-over_corner = Over a corner, { NUM($turn_deg, decimals: 0) } deg off the first side:

photograph_list-stereo_pair = Stereo pair:

# $number = 1
# $of = 3
# $left = true
photograph_list-pair = pair { $number } of { $of }, { $left ->
        [yes] left
        *[no] right
    } photograph, portrait format, both alike

# $ring_m = 9.4
# $eye_m = 1.7
# $pairs_m = 5.6
# $base_m = 1.12
photograph_list-distances = Ring: { NUM($ring_m, decimals: 1) } m before the walls, { NUM($eye_m, decimals: 1) } m high; pairs from { NUM($pairs_m, decimals: 1) } m, base { NUM($base_m, decimals: 2) } m.

# $distance_m = 5.0
photograph_list-clearance = No photograph from nearer than { NUM($distance_m) } m.

# $n = 6
# $oriented = 5
# $missing = 1
# $beside = 0
photograph_list-ticked = List of { $n } photographs: { $oriented } oriented; { $missing } missing, { $beside } beside the list.

# $kind = "doubled"
# $names = ["03"]
photograph_list-named = { $kind ->
        [doubled] Taken more than once
        [rolled] Camera not held as listed
        [beside] Beside the list
        *[not_oriented] Not oriented
    }: { $names }.

# $number = "05"
# $text = "front, left"
photograph_list-not_taken = Missing { $number }: { $text }
