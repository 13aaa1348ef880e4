mission-no_crs = The mission has local coordinates; a vehicle needs positions on the earth.
    .do = Plan it in a coordinate system: { OPTION("crs", "EPSG:CODE") }.

# $vehicle = "mavic-9"
# $known = ["mavic-3e", "phantom-4-rtk"]
mission-vehicle_unknown = Vehicle { $vehicle } is unknown.
    .do = Use one of { LIST($known, most: 20) }, or give { OPTION("speed", "M_S") }, { OPTION("climb", "M_S") }, { OPTION("battery", "MINUTES") }.

# $known = ["mavic-3e", "phantom-4-rtk"]
mission-camera_missing = The camera is missing.
    .do = Give a vehicle ({ LIST($known, most: 20) }), or { OPTION("camera") } as a photograph, a calibration, or WIDTHxHEIGHT,C in pixels.

# $camera = "'d5100'"
# $known = ["mavic-3e", "phantom-4-rtk"]
mission-camera_unknown = Camera { $camera } is neither a file nor a known camera.
    .do = Use one of { LIST($known, most: 20) }, or WIDTHxHEIGHT,C in pixels, such as 5472x3648,3650.

mission-no_folder = The file has no folder of way points; it was not written as a mission.
    .do = Check that it is the right file.

mission-no_way_point = The mission has no way point.
    .do = Check that it is the right file.

mission-no_height = The height above the take-off point is missing; it was not written as a mission.
    .do = Check that it is the right file.

# $reference = "altitudemode 1"
# $needed = "altitudemode 0"
mission-height_reference = Heights refer to { $reference }; heights above the take-off point ({ $needed }) are needed.
    .do = Save the mission with these heights.

mission-no_table = The file has no [way_points]; it is not a flight plan.
    .do = Check that it is the right file.

# $needed = ["X", "Y", "Z"]
mission-columns = The columns of the way points differ from those needed.
    .do = Give { LIST($needed, most: 12) }.

# $line_number = 7
# $n = 5
mission-line_unknown = Flight line { $line_number } does not exist; { $n } lines are defined, counted from 0.
    .do = Correct the number.

# $pattern = "'spiral'"
# $known = ["grid", "corridor", "facade"]
mission-unknown_pattern = Pattern { $pattern } is unknown.
    .do = Use one of { LIST($known, most: 20) }.

mission-area_in_zones = No-go zones cover the whole area of the mission.
    .do = Check the zones and their coordinate system.

# $n = 150000
# $most = 100000
mission-too_many_photographs = The mission needs { $n } photographs; at most { $most } are possible.
    .do = Use a larger ground sampling distance ({ OPTION("gsd") }), or divide the area.

mission-line_no_extent = All points of the line are identical.
    .do = Give at least two different points.

# $speed_mps = 20.0
# $most_mps = 15.0
# $vehicle = "multirotor"
mission-speed_of_vehicle = A speed of { $speed_mps } m/s exceeds the { $most_mps } m/s of { $vehicle }.
    .do = Give a lower speed: { OPTION("speed") }.

# $base_m = 5.25
# $speed_mps = 12.0
# $needed_s = 0.44
# $camera = "phantom4"
# $interval_s = 2.0
# $most_mps = 2.6
mission-camera_interval = Camera { $camera } needs { $interval_s } s between photographs; the mission has { NUM($needed_s, decimals: 2) } s.
    .why = The base is { NUM($base_m, decimals: 2) } m at { $speed_mps } m/s.
    .do = Fly at most { NUM($most_mps, decimals: 1) } m/s ({ OPTION("speed") }), higher, or with less overlap ({ OPTION("overlap") }).

# $flight_line = "line 12"
# $needed_min = 30.5
# $usable_min = 20.0
# $minutes_min = 25.0
mission-battery = { $flight_line } is out of reach of one battery: the way there and back takes { NUM($needed_min, decimals: 1) } min.
    .why = { NUM($usable_min, decimals: 1) } of { $minutes_min } min are usable.
    .do = Take off nearer to it ({ OPTION("take_off") }), or use a vehicle with more endurance ({ OPTION("battery") }).

# $waypoint = 12
mission-no_stop = Waypoint { $waypoint } starts photographs, but no later one stops them.
    .do = Add a stop after it.

mission-no_photographs = The mission has no photograph: no waypoint starts or takes one.
    .do = Give a mission with photographs.

# $waypoint = 3
# $base_m = 0.0
mission-base_not_positive = Waypoint { $waypoint }: the base between photographs is { $base_m } m.
    .do = Give a base above 0.

# $waypoint = 3
# $n = 200000
# $base_m = 0.01
# $most = 100000
mission-too_many_on_line = Waypoint { $waypoint } starts { $n } photographs, one every { $base_m } m; at most { $most } are possible.
    .do = Give a longer base.

# $tilt_deg = 60.0
# $angle_deg = 64.0
# $most_deg = 53.0
mission-view_to_horizon = A view tilted by { NUM($tilt_deg, decimals: 0) }° with a field of { NUM($angle_deg, decimals: 0) }° reaches the horizon.
    .do = Give a tilt below { NUM($most_deg, decimals: 0) }°: { OPTION("tilt") }.

# $kind = "rows"
# $n = 2000000.0
# $most = 100000
mission-too_many_parts = The mission needs { $n } { $kind ->
        [lines] lines
        [rows] rows
       *[photographs] photographs
     }; at most { $most } are possible.
    .do = Check the coordinate system of the area, and the ground sampling distance in metres ({ OPTION("gsd") }).

mission-heights_missing = The heights of the object above ground are missing.
    .do = Give { OPTION("heights", "LOW", "TOP") }.

# $top_m = 2.0
# $low_m = 5.0
mission-heights_order = The top of the object, { $top_m } m, is not above its lower end, { $low_m } m.
    .do = Correct { OPTION("heights") }.

# $vehicle = "multirotor"
# $entry = "climb"
# $value = 0.0
mission-vehicle_not_positive = Vehicle { $vehicle }: { $entry } is { $value }.
    .do = Give a value above 0.

# $end = "begins"
# $x = 533000.5
# $y = 5337000.2
mission-way_in_zone = A way { $end ->
        [begins] starts
       *[ends] ends
     } in a no-go zone, at { NUM($x, decimals: 1) }, { NUM($y, decimals: 1) }.
    .do = Move the take-off ({ OPTION("take_off") }) or the zone.

# $x = 533000.5
# $y = 5337000.2
# $to_x = 533100.5
# $to_y = 5337100.2
mission-no_way = No way from { NUM($x, decimals: 1) }, { NUM($y, decimals: 1) } to { NUM($to_x, decimals: 1) }, { NUM($to_y, decimals: 1) } avoids the no-go zones.
    .do = Take off on the same side of the zones, or open them.

# $name = "'a/b'"
mission-name = { $name } is not possible as a file name.
    .do = Give { OPTION("name") } of letters, digits, blanks, points, - and _.

# $gsd_m = 2.0
# $distance_m = 7200.0
# $limit_m = 1200.0
# $times = 10
# $unit = "cm"
mission-gsd_too_large = { OPTION("gsd", $gsd_m) }: this pixel needs a distance of { NUM($distance_m, decimals: 0) } m (limit { NUM($limit_m, decimals: 0) } m).
    .why = The limit is { $times } times { OPTION("height_limit") }.
    .do = Give the pixel size in metres{ $unit ->
        [cm] ; it is probably in centimetres
        [mm] ; it is probably in millimetres
       *[other] { "" }
     }.

# $pattern = "grid"
# $area = "site.kml"
# $wanted = "area"
# $kind = "line"
mission-shape = Pattern { $pattern } needs { $wanted ->
        [area] a polygon
        [line] a line
       *[place] a point or a polygon
     }; { $area } contains { $kind ->
        [area] polygons
        [line] lines
       *[place] points
     }.
    .do = Choose another { OPTION("pattern") }, or another file.

# $area = "site.kml"
# $n = 3
mission-several_outlines = { $area } contains { $n } outlines; a mission has one.
    .do = Give them one by one, or join them into one.

# $speed = 8.0
# $exposure = 500
# $blur = 1.8
# $limit = 1.0
# $slower = 4.4
mission-blur = At { $speed } m/s and 1/{ $exposure } s the image moves by { NUM($blur, decimals: 1) } px (limit { $limit } px).
    .do = Fly at { NUM($slower, decimals: 1) } m/s, or expose more briefly.

# $n = 3
# $metres = 120.0
# $kind = "metres"
mission-zones_taken_out = No-go zones take out { $kind ->
    [metres] { NUM($metres, decimals: 0) } m of lines
    *[photographs] { $n ->
        [one] one photograph
        *[other] { $n } photographs
    }
 }.
    .why = What is visible from there alone is not photographed.

# $limit = "camera_interval"
# $speed = 4.0
# $vehicle = 12.0
mission-speed_limited = { $limit ->
    [camera_interval] The interval of the camera
    *[blur] Motion blur
 } limits the speed to { NUM($speed, decimals: 1) } m/s (vehicle: { $vehicle } m/s).

# $speed = 8.0
# $raised = 6.0
mission-ground_too_steep = The ground is steeper than the vehicle climbs at { NUM($speed, decimals: 1) } m/s: up to { NUM($raised, decimals: 1) } m too high.
    .do = Fly more slowly to follow the ground.

# $height_m = 152.3
# $limit_m = 120.0
# $open_category = true
mission-too_high = Photographs are up to { NUM($height_m, decimals: 0) } m above ground; { $limit_m } m are allowed{ $open_category ->
        [yes] {" "}(EU 2019/947, open category)
        *[no] {""}
    }.
    .do = Plan a smaller GSD, follow the terrain, or raise { OPTION("height_limit") } where that is permitted.

# $distance_m = 712.0
# $limit_m = 500.0
mission-out_of_sight = The flight is up to { NUM($distance_m, decimals: 0) } m from the take-off; visual line of sight is { $limit_m } m ({ OPTION("sight") }).
    .do = Take off nearer to the middle, or divide the area.

# $minutes = 34.5
# $usable = 31.5
mission-battery_exceeded = A flight takes { NUM($minutes, decimals: 1) } min; { NUM($usable, decimals: 1) } min of a battery are usable.
    .do = Divide the area, or give the battery's flight time ({ OPTION("battery") }).

# $interval_s = 0.62
# $camera = "FC6310R"
# $needed_s = 2.5
mission-interval_short = The interval of photographs is { NUM($interval_s, decimals: 2) } s; camera { $camera } needs { $needed_s } s.
    .do = Fly more slowly ({ OPTION("speed") }).

# $motion_px = 3.2
mission-rolling_motion = During the read-out of a frame the rolling shutter moves by { NUM($motion_px, decimals: 1) } px on the ground.
    .do = Stop for the photographs, fly more slowly, or adjust with the rolling platform.

# $share = 0.042
# $photographs = 3
# $where = "edges"
# $along = 0.8
# $across = 0.7
mission-seen_rarely = { NUM(PERCENT($share), decimals: 1) } % of the area is in fewer than { $photographs } photographs.
    .why = { $where ->
        [middle] { PERCENT($along) } % along and { PERCENT($across) } % across are too little for its middle.
        [zones] These places are at no-go zones.
        *[edges] These places are at its edges.
    }
    .do = { $where ->
        [middle] Raise the overlap ({ OPTION("overlap") }).
        [zones] Tilt the views towards the zones ({ OPTION("tilt") }), or make the zones smaller.
        *[edges] Widen the margin ({ OPTION("margin") }).
    }

# $direction = "along"
# $overlap = 0.61
# $asked = 0.8
# $cause = "relief"
mission-overlap_low = The overlap { $direction ->
        [along] along the lines
        *[across] across the lines
    } is only { PERCENT($overlap) } %; { PERCENT($asked) } % are required.
    .why = { $cause ->
        [relief] Lines follow the heights below them; higher ground beside them is nearer.
        [facade] The rows in front of the facade are that far apart.
        [orbit] The photographs and rings round the object are that far apart.
        *[pattern] The lines are that far apart.
    }
    .do = { $cause ->
        [relief] Fly higher ({ OPTION("gsd") }, { OPTION("height") }), or raise the overlap ({ OPTION("overlap") }).
        [orbit] Raise the overlap ({ OPTION("overlap") }), or the number of rings ({ OPTION("rings") }).
        *[pattern] Raise the overlap ({ OPTION("overlap") }).
    }

mission-holes_flown_over = Holes in the area are flown over.
    .do = To spare them, give them as no-go zones ({ OPTION("no_go") }).

# $n = 2
# $share = 0.034
# $width_m = 30.0
# $length_m = 30.0
# $x = 364120.0
# $y = 5551740.0
mission-ground_holes = { $n } { $n ->
        [one] hole
        *[other] holes
    } in the ground heights, { NUM(PERCENT($share), decimals: 1) } % of the area; overlaps there are unknown.
    .why = The largest is { NUM($width_m, decimals: 0) } x { NUM($length_m, decimals: 0) } m at { NUM($x, decimals: 0) }, { NUM($y, decimals: 0) }.

# $name = "mission.csv"
# $n = 132
# $program = "Litchi"
# $most = 99
mission-too_many_way_points = { $name } has { $n } way points; { $program } takes { $most }.
    .do = Follow the ground less closely ({ OPTION("follow") }), or divide the area.
