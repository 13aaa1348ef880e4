# $number = 1
# $left = 5000.0
# $right = 5100.0
# $bottom = 2000.0
# $top = 2080.0
section-outside = Line { $number } is outside the height grid.
    .why = The grid covers X { NUM($left, digits: 10) } to { NUM($right, digits: 10) }, Y { NUM($bottom, digits: 10) } to { NUM($top, digits: 10) }.
    .do = Correct { OPTION("line") }.

# $number = 1
# $n = 20000000.0
# $most = 1000000
section-too_many_places = Line { $number } would have { $n } places; at most { $most } are possible.
    .do = Choose a larger { OPTION("step") }.

# $name = "line 1"
# $length = 42.5
# $at = 60.0
section-beyond_end = { $name } is { NUM($length, digits: 6) } long; { OPTION("between") } has a place at { NUM($at, digits: 6) }.
    .do = Give two places along the line.

# $at = 12.5
section-same_place = { OPTION("between") } has the place { NUM($at, digits: 6) } twice.
    .do = Give two different places.

# $name = "line 1"
# $at = 12.5
# $x = 5012.25
# $y = 2034.5
# $unit = "m"
section-no_height = { $name } has no height at { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }), nor anywhere else.
    .do = Choose another line, or fill the hole: { OPTION("fill", "WIDTH") }.

# $name = "line 1"
# $at = 12.5
# $x = 5012.25
# $y = 2034.5
# $unit = "m"
# $nearest = 14.0
# $distance = 1.5
section-no_height_at = { $name } has no height at { NUM($at, digits: 6) } { $unit } (X { NUM($x, digits: 8) }, Y { NUM($y, digits: 8) }).
    .why = The nearest height is at { NUM($nearest, digits: 6) } { $unit }, { $distance } { $unit } away.
    .do = Choose another place for { OPTION("between") }, or fill the hole: { OPTION("fill", "WIDTH") }.

# $name = "line 1"
# $share = 0.8
section-partly_measured = { $name }: the mean height is that of { PERCENT($share) } % of the line.
    .why = On the rest nothing was measured.
