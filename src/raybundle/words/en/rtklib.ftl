# $datum = "'JGD2011'"
rtklib-datum = The positions refer to the datum { $datum }.
    .do = Write the solution in WGS84.

# $heights = "'geodetic'"
rtklib-heights = The heights are { $heights }; they refer to a geoid that the file does not name.
    .do = Write ellipsoidal heights (RTKLIB: out-height =ellipsoidal).

# $names = ["e-baseline", "n-baseline"]
# $needed = ["latitude", "longitude", "height"]
rtklib-columns = The columns are { $names }.
    .do = Write the solution as { $needed }.

# $text = "'abc'"
rtklib-line = A line begins with date and time, or week and second, not with { $text }.
    .do = Correct the line.

# $text = "'2026/13/01 10:00:00'"
rtklib-date = { $text } is not a valid date and time.
    .do = Correct the line.

rtklib-baselines = The file has baselines from a base station.
    .do = Write the solution as latitude, longitude and height.

# $value = "47:30"
rtklib-not_decimal_degrees = { $value }: the angles are not in decimal degrees.
    .do = Write decimal degrees.

rtklib-beyond_degrees = A latitude or longitude is outside ± 90° or ± 180°.
    .do = Check that it is the right file.

# $n = 2400
rtklib-track = The file is a track of { $n } epochs without relation to photographs.
    .do = Give the solution of the camera events (NAME_events.pos).
