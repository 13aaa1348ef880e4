flight_check-no_positions = None of the photographs has a position.
    .do = Give a file of positions.

# $away_m = 3400.0
# $mission = "quarry"
flight_check-other_place = No photograph is where mission { $mission } planned one; on average they are { NUM($away_m, decimals: 0) } m away.
    .do = Check that it is the plan of this flight.

flight_check-no_crs = The mission has local coordinates; photographs have positions on the earth.
    .do = Plan it in a coordinate system: { OPTION("crs", "EPSG:CODE") }.
