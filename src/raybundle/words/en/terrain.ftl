# $x = 533000.5
# $y = 5337000.2
# $low_x = 532000.0
# $high_x = 532900.0
# $low_y = 5336000.0
# $high_y = 5337500.0
terrain-flight_beyond = The flight reaches { NUM($x, decimals: 1) }, { NUM($y, decimals: 1) }, beyond the height grid.
    .why = The grid covers X { NUM($low_x, decimals: 1) } to { NUM($high_x, decimals: 1) }, Y { NUM($low_y, decimals: 1) } to { NUM($high_y, decimals: 1) }.
    .do = Give a height grid that covers the area, its margin and the take-off.

# $x = 533000.5
# $y = 5337000.2
# $n = 12
terrain-void_below_flight = The height grid has no height at { NUM($x, decimals: 1) }, { NUM($y, decimals: 1) }, below the flight ({ $n } such places).
    .do = Fill the holes of the grid, or give another.

# $largest = 80.0
# $side = 120.0
terrain-object_too_wide = { OPTION("largest", $largest) } is more than half of the shorter side ({ NUM($side, digits: 4) }).
    .why = No ground remains between such objects.
    .do = Give the width of the largest object on the ground.

# $largest = 0.2
# $cell = 0.5
terrain-object_below_cell = { OPTION("largest", $largest) } is less than a cell ({ NUM($cell, digits: 6) }).
    .why = Such small objects are not in the grid.
    .do = Give the width of the largest object on the ground.

# $slope = 300.0
# $rise = 1.5
# $range = 1.2
terrain-slope_too_large = { OPTION("slope", $slope) } rises { $rise } over a cell; all heights differ by { $range } only.
    .why = No object could stand out from the ground.
    .do = Give the slope of the ground in percent.

terrain-no_ground = No cell remains as ground.
    .do = Give a larger { OPTION("slope") }.

# $share = 0.6
terrain-spans_gaps = { PERCENT($share) } % of this ground is interpolated across gaps.
    .do = Choose a smaller { OPTION("largest") } or a larger { OPTION("slope") }.
