

flight_check-no_positions = None of the photographs has a position.
    .do = Give a file of positions.

# $away_m = 3400.0
# $mission = "quarry"
flight_check-other_place = No photograph is where mission { $mission } planned one; on average they are { NUM($away_m, decimals: 0) } m away.
    .do = Check that it is the plan of this flight.

flight_check-no_crs = The mission has local coordinates; photographs have positions on the earth.
    .do = Plan it in a coordinate system: { OPTION("crs", "EPSG:CODE") }.

# $terrain = "dsm.tif"
flight_check-ground_of_plan = The plan followed { $terrain }, which is not given; its planned heights define the ground.
    .do = Give the raster ({ OPTION("dem") }).

# $n = 3
# $of = 120
# $example = "DJI_0007.JPG"
flight_check-some_unplaced = { $n } of { $of } photographs have no position ({ $example }, ...); they do not count.

# $n = 2
# $example = "DJI_0007.JPG"
flight_check-not_decoded = { $n } { $n ->
        [one] photograph is
        *[other] photographs are
    } not readable ({ $example }, ...).

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
