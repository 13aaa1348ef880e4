flight_check-no_positions = None of the photographs has a position.
    .do = Give a file of positions.

# $away_m = 3400.0
# $mission = "quarry"
flight_check-other_place = No photograph is where mission { $mission } planned one; on average they are { NUM($away_m, decimals: 0) } m away.
    .do = Check that it is the plan of this flight.

flight_check-no_crs = The mission has local coordinates; photographs have positions on the earth.
    .do = Plan it in a coordinate system: { OPTION("crs", "EPSG:CODE") }.

# $n = 1
# $names = ["DJI_0031.jpg (3.2 px)"]
flight_check-blurred = { $n } blurred { $n ->
        [one] photograph does
        *[other] photographs do
    } not count: { $names }.

# $n = 1
# $names = ["DJI_0151.jpg"]
flight_check-tilted = { $n } { $n ->
        [one] photograph, tilted too far, does
        *[other] photographs, tilted too far, do
    } not count: { $names }.
