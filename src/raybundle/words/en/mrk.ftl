mrk-empty = The file is empty.
    .why = The aircraft recorded no exposure.
    .do = Copy it again from the aircraft.

# $crs = "EPSG:25832"
mrk-not_geographic = An MRK file has longitude and latitude; the positions are in { $crs }.
    .do = Choose another format.

# $text = "'abc'"
mrk-line = A line begins with number, second and [week], not with { $text }.
    .do = Correct the line.

# $tag = "Lat"
mrk-tag_twice = The number marked { $tag } occurs twice.
    .do = Correct the line.

# $tag = "Lat"
# $text = "'...,V'"
mrk-tag_missing = The number marked { $tag } is missing; the line ends with { $text }.
    .do = Get the complete file.

# $tag = "Lat"
# $value = 411.0
# $limit = 90.0
mrk-out_of_range = { $tag } = { $value } is outside ± { $limit }.
    .do = Correct the line.

mrk-sigmas_missing = Three standard deviations (north, east, up) must follow the height.
    .do = Complete the line.

# $sigmas_m = [-1.0, 0.02, 0.05]
# $largest_m = 1000.0
mrk-sigmas_out_of_range = { $sigmas_m } are no standard deviations in metres (0 to { $largest_m }).
    .do = Correct the line.

# $second = 700000.0
mrk-second_of_week = { NUM($second, digits: 9) } is not a second of a week.
    .do = Correct the line.
