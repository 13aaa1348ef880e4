# $distance = 120000.0
# $exchanged = 12.0
# $photographs = 20
# $distance_km = 120.0
# $exchanged_km = 0.012
# $table = "positions.csv"
# $geographic = true
# $ids = ["IMG_1"]
positions_axes-list = { $geographic ->
     [yes] Longitude and latitude
     *[no] Easting and northing
    } in { $table } seem to be exchanged.
    .why = They are { $distance_km } km from the positions in the photographs, exchanged { $exchanged_km } km; the positions in the photographs are used.
    .do = Exchange the two columns in { $table }.

# $n = 20
# $before_m = 1200.0
# $after_m = 0.4
# $ids = ["IMG_1"]
positions_axes = Latitude and longitude of the positions seem to be exchanged; no position is used.
    .why = The { $n } positions fit the photographs to { NUM($before_m, digits: 2) } m as given, and to { NUM($after_m, digits: 2) } m exchanged.
    .do = Exchange the two columns, or their names, in the file of positions.
