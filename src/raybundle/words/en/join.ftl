join-one_block = Joining needs at least two blocks.
    .do = Give two or more projects or blocks.

# $name = "south"
# $base = "north"
# $n = 1
# $points = ["P1"]
# $least = 3
join-too_few_common = { $name } and { $base } have { $n } common { $n ->
        [one] point
       *[other] points
     } with coordinates; { $least } are needed.
    .why = Points count that are named by hand or have codes.
    .do = Measure more common points in both blocks.

# $point = "P7"
# $name = "south"
# $base = "north"
# $others = 2
# $apart = 0.51
# $limit = 0.02
# $unit = "m"
join-control_contradicts = Point { $point }: given coordinates in { $name } and { $base } differ by { $apart } { $unit } (limit { $limit } { $unit }).
    .why = { $others ->
        [0] The limit follows from the standard deviations.
        [one] The limit follows from the standard deviations. 1 other point contradicts too.
       *[other] The limit follows from the standard deviations. { $others } other points contradict too.
     }
    .do = Correct the coordinates, or transform both blocks into one coordinate system.

# $name = "south"
# $tables = ["directions"]
# $base = "north"
# $tilt_deg = 12.0
join-vertical_tilted = The frame of { $base } is tilted by { NUM($tilt_deg, digits: 2) }° against the vertical of { $name }.
    .why = { $name } has observations that refer to the vertical: { $tables }.
    .do = Give { $name } first, or level { $base } as well.

# $camera = "d5100"
# $name = "south"
# $model = "brown"
# $width_px = 4928
# $height_px = 3264
# $other_model = "fisheye"
# $other_width_px = 6000
# $other_height_px = 4000
join-cameras_differ = Camera { $camera } of { $name } is not the camera of the same name in the other block.
    .why = They are { $model }, { $width_px } x { $height_px } px, and { $other_model }, { $other_width_px } x { $other_height_px } px.
    .do = Treat them as different cameras.

# $name = "south"
# $kind = "bars"
# $n = 2
join-scale_of = Scale of { $name }: { $kind ->
        [control] control points
        [positions] observed positions
       *[bars] { $n ->
            [0] unknown
            [one] one scale bar
           *[other] { $n } scale bars
        }
     }.

# $start = "M1"
# $end = "M2"
# $length = 1.2003
# $unit = "m"
join-scale_bar = Scale bar { $start } - { $end }: { NUM($length, digits: 10) } { $unit }.

# $n = 2
# $first = "north"
# $second = "south"
# $names = ["img_01", "img_02"]
# $name = "south"
join-same_measurement = All photographs of { $name } ({ $n }) have the same image points in { $first } and in { $second }.
    .why = They would count twice: { LIST($names, most: 3) }.
    .do = Leave { $name } out.

# $n = 2
# $first = "north"
# $second = "south"
# $names = ["img_01", "img_02"]
join-same_photographs = { $n } { $n ->
        [one] photograph has
       *[other] photographs have
     } the same image points in { $first } and in { $second }: { LIST($names, most: 3) }.
    .why = They count twice, and standard deviations come out too small.
    .do = Exclude them from one of the two.

# $name = "south"
# $base = "north"
# $least = 4
join-too_few_to_test = No common point is tested: { $name } and { $base } have fewer than { $least }.

# $name = "south"
join-points_not_tested = Common points of { $name } are not tested:

# $name = "north"
join-block_not_adjusted = No common point is tested: { $name } cannot be adjusted by itself:

# $moved = 9
# $n = 12
# $name = "south"
# $base = "north"
join-points_moved = { $moved } of { $n } common points of { $name } and { $base } are not the same point.
    .do = Check whether names belong to another object, or are exchanged.

# $name = "south"
# $base = "north"
join-scales_not_tested = The scales of { $base } and { $name } are not compared:

# $name = "south"
# $base = "north"
# $factor = 1.00102
# $sigma = 2.1e-05
join-scales_contradict = Lengths of { $name } are { NUM($factor, digits: 7) } ± { NUM($sigma, digits: 2) } times those of { $base }.
    .why = One of the two scales is wrong.
    .do = Check these lengths:

# $name = "south"
# $base = "north"
# $F = 12.3
# $shift_m = 0.5
# $turn_mrad = 0.02
join-frames_contradict = { $name } and { $base } are not in one frame: shift { NUM($shift_m, digits: 2) } m, rotation { NUM($turn_mrad, digits: 2) } mrad (F { $F }).
    .do = Compare their control.

# $name = "south"
# $base = "north"
# $factor = 1000.02
# $likely = true
# $unit = "mm"
# $base_unit = "m"
join-other_unit = Lengths of { $name } are { NUM($factor, digits: 6) } times those of { $base }.
    .why = { $likely ->
        [yes] Probably { $name } is in { $unit } and { $base } in { $base_unit }.
       *[no] The unit of one of them is wrong.
     }
    .do = Give lengths in the unit of block.toml:

# $name = "south"
# $base = "north"
join-cameras_not_compared = Cameras of { $name } and { $base } are not compared:

# $camera = "d5100"
# $symbol = "c"
# $base = "north"
# $name = "south"
# $unit = "mm"
# $first = 24.012
# $second = 24.251
# $held = false
# $times = 9.4
# $limit = 5.0
join-camera_contradicts = Camera { $camera } is not the same in { $base } and in { $name } (limit { $limit } standard deviations).
    .why = { $symbol } is { NUM($first, digits: 6) } { $unit } in { $base } and { NUM($second, digits: 6) } { $unit } in { $name }{ $held ->
        [yes] { "" }, both fixed
       *[no] { "" }, { NUM($times, digits: 2) } standard deviations apart
     }.
    .do = Leave out { OPTION("same_camera") }: each project then has its own camera.

# $camera = "d5100"
# $symbol = "c"
# $base = "north"
# $name = "south"
# $unit = "mm"
# $first = 24.012
# $second = 24.251
# $held = false
# $times = 3.1
# $F = 4.2
join-camera_differs = Camera { $camera } differs significantly between { $base } and { $name } (F { $F }).
    .why = { $symbol } is { NUM($first, digits: 6) } { $unit } in { $base } and { NUM($second, digits: 6) } { $unit } in { $name }{ $held ->
        [yes] { "" }, both fixed
       *[no] { "" }, { NUM($times, digits: 2) } standard deviations apart
     }.
    .do = Check whether its focus or zoom changed.

# $n = 12
# $others = 5
# $names = ["south"]
join-dots_renumbered = Dots without a code have new numbers: { $n } are common by position, { $others } occur in { $names } alone.
    .why = Numbers of such dots differ between the blocks; the measurements do not change.
    .do = Use the new numbers in tables for the joined block.

# $name = "south"
# $F = 2.4
join-points_beyond_sigma = Unmoved common points of { $name } differ more than their standard deviations explain (F { $F }).
    .why = These are too small, or many points moved a little.

# $name = "north"
# $control = true
join-frame_of = The frame is that of { $name }, which has { $control ->
        [yes] control or positions
       *[no] a scale
     }.
    .why = All coordinates of the joined block are in this frame.
    .do = If another frame is needed, transform the result: raybundle datum.

# $n = 8
# $name = "south"
# $example = "south:img_01"
join-images_renamed = { $n } { $n ->
        [one] image
       *[other] images
     } of { $name } { $n ->
        [one] has
       *[other] have
     } new names, such as { $example }: the old ones exist in another block.
    .why = Names are unique in a block; the measurements do not change.
    .do = Use the new names in tables and options for the joined block.

# $n = 1
# $name = "south"
# $ids = ["d5100"]
# $renamed = ["south:d5100"]
join-cameras_renamed = Cameras of { $name } are treated as different cameras: { LIST($ids, most: 9) } { $n ->
        [one] is
       *[other] are
     } now { LIST($renamed, most: 9) }.
    .why = Each camera has an interior orientation of its own in the joined block.
    .do = If both are the same camera, use { OPTION("same_camera", "True") }.

# $name = "south"
# $base = "north"
# $away_m = 1234.5
# $kind = "local"
# $known = true
# $system = "ETRS89 / UTM 33N"
# $origin = [500000.0, 5300000.0, 400.0]
join-other_frame = { $name } is transformed to the frame of { $base }, with the origin { NUM($away_m, decimals: 3) } m away.
    .why = The original frame is { $kind ->
        [projected] { $system }
        [geocentric] geocentric
       *[local] local{ $known ->
            [yes] { " " }in { $system }
           *[no] { " " }(longitude, latitude, height)
        }, origin { $origin }
     }.
    .do = If another frame is needed, transform the result: raybundle datum.

# $point = "P12"
# $block = "bridge"
join-point_incomplete = Point { $point } of { $block } lacks a coordinate and cannot be transformed into the other frame.
    .do = Adjust the block first.

# $block = "bridge"
# $tables = ["height_differences"]
# $tilt_deg = 0.4
# $limit_deg = 0.01
join-vertical_of_tables = The frames differ in their verticals by { NUM($tilt_deg, digits: 2) }° (limit { NUM($limit_deg, digits: 2) }°).
    .why = { $tables } of { $block } refer to the vertical.
    .do = Give both blocks in frames of one origin.

# $block = "april"
# $other = "may"
# $unit = "m"
# $other_unit = "mm"
join-frames_differ = { $block } ({ $unit }) and { $other } ({ $other_unit }) are in frames that cannot be transformed into each other.
    .do = Transform both into one coordinate system in metres (convert to a block, { OPTION("crs") }). Or, for a block of unknown place, delete [frame] in block.toml.

# $block = "april"
# $system = "EPSG:25832"
join-frame_projected = { $block } is in coordinates of { $system }.

# $block = "april"
join-frame_geocentric = { $block } is in a geocentric frame.

# $block = "april"
# $longitude_deg = 11.5
# $latitude_deg = 48.1
# $height_m = 520.0
join-frame_local = { $block } is in a local frame at longitude { NUM($longitude_deg, decimals: 6) }°, latitude { NUM($latitude_deg, decimals: 6) }°, { NUM($height_m, decimals: 3) } m.

# $block = "april"
# $system = "EPSG:25832"
# $x_m = 534700.0
# $y_m = 5338160.0
# $height_m = 520.0
# $geoid_m = 46.1
# $geoid = true
join-frame_of_system = { $block } is in a local frame of { $system }.
    .why = Its origin is { NUM($x_m, decimals: 3) }, { NUM($y_m, decimals: 3) }, { NUM($height_m, decimals: 3) } m{ $geoid ->
        [yes] {" "}(geoid { $geoid_m } m above the ellipsoid)
       *[no] {""}
    }.

# $n = 2
# $name = "block-b"
# $points = ["7", "8"]
# $distances = [0.31, 0.2]
# $unit = "m"
join-points_apart = { $name }: points of one name lie apart and stay two points: { $points }.
    .why = Such a point has moved, or is another point.
    .do = Check these points.

# $name = "block-b"
# $n = 12
# $scale = 1.0002
# $rms = 0.004
# $unit = "m"
# $frame = "moved"
join-block = { $name }: { $frame ->
    [same] in the same frame
    *[moved] transformed by { $n } common { $n ->
        [one] point
        *[other] points
    }, scale { NUM($scale, digits: 6) }, coordinates { NUM($rms, digits: 3) } { $unit } apart (rms)
 }.
