# $table = "line_times"
# $n = 1
line_scene-table_order = { $table ->
        [line_times] Line times
       *[viewing_directions] Viewing directions
     } ({ $n } entries) are too few or not in increasing order.
    .do = Give at least two entries in increasing order.

line_scene-times_not_monotonic = Line times neither all increase nor all decrease along the image.
    .do = Correct the table of line times.

# $x_px = 120.5
# $y_px = 3300.2
# $miss_m = 1200.0
# $height_m = 0.0
line_scene-ray_misses_body = The ray of image point { NUM($x_px, decimals: 2) }, { NUM($y_px, decimals: 2) } px misses the body by { NUM($miss_m, decimals: 1) } m.
    .why = The intersection is at height { $height_m } m; the image shows space beyond the limb, or the attitude is wrong.
    .do = Check the attitude of the scene.

# $point = 4
# $longitude_deg = 16.371
# $latitude_deg = 48.208
# $height_m = 171.0
# $last_line = 43000.5
# $lines = 42000
line_scene-point_not_seen = Point { $point } is not in this scene.
    .why = It is at longitude { NUM($longitude_deg, decimals: 6) }°, latitude { NUM($latitude_deg, decimals: 6) }°, height { NUM($height_m, decimals: 1) } m; last line tried { NUM($last_line, decimals: 1) } of { $lines }.
    .do = Check that point and scene belong together.

# $name = "'rw'"
# $known = ["rx", "ry"]
# $n = 2
line_scene-smooth_unknown = smooth: { $name } is not an axis of a curve.
    .do = { $n ->
        [0] Leave smooth out; this scene has no curve
       *[other] Use one of { LIST($known, most: 9) }
     }.

# $height_m = 900000.0
# $above_m = 200000.0
line_scene-below_ground = The ground height of { $height_m } m is { NUM($above_m, decimals: 1) } m above the sensor.
    .do = Give the mean height of the ground as height_m.
