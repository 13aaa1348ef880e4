join-one_block = Joining needs at least two blocks.

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
