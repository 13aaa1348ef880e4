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
