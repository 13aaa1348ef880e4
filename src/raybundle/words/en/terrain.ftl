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
