# $clock = "UTC"
position_list-clock = Times are { $clock }, not GPS time, and not used.

# $name = "flight.pos"
position_list-correlations = Correlations of the positions in { $name } are not used; standard deviations are.
    .do = To use them, give the positions as stations.csv of a block.

# $n = 2
# $of = 40
position_list-disabled = { $n } of { $of } positions are disabled in the list and not used.

position_list-ellipsoid = Heights are taken as heights above the ellipsoid of WGS 84.

position_list-estimated = The list has estimated coordinates alone: they are no observations of a receiver.

# $n = 2
# $of = 40
position_list-exposures_without = { $n } of { $of } exposures have no position.

position_list-heights_open = The file does not state the reference of its heights.

# $n = 2
# $of = 40
position_list-no_fix = { $n } of { $of } positions are 0, 0 and not used: the receiver had no fix.

# $n = 2
# $of = 40
position_list-not_fixed = { $n } of { $of } positions have no fixed solution.

position_list-of_antenna = Positions are those of the antenna, by the order of photographs' names; ellipsoidal heights.

position_list-of_camera = Positions are those of the camera, reduced from the antenna; heights above the ellipsoid.

# $latitude_deg = 48.1
# $south = false
# $longitude_deg = 11.5
# $west = false
position_list-order_of_pix4d = No column names: latitude, longitude, height, the order of Pix4D; first place { NUM($latitude_deg, digits: 6) } { $south ->
        [yes] S
        *[no] N
    }, { NUM($longitude_deg, digits: 6) } { $west ->
        [yes] W
        *[no] E
    }.

position_list-sigma_columns = Columns of standard deviations have other names and are not used.

# $order = "xyz"
position_list-unnamed = No column names: taken as { $order ->
        [xyz] X, Y, Z
        [latitude_longitude] latitude, longitude, height
        *[longitude_latitude] longitude, latitude, height
    }.

# $n = 38
# $of = 40
# $name = "flight.MRK"
position_list-used = { $n } of { $of } photographs get their position from { $name }.

# $reading = "opk-gon"
# $by_size = false
position_list-orientations = Exterior orientations are read as { $reading }{ $by_size ->
     [yes] , the unit by the size of the angles
     *[no] { "" }
    }.

# $readings = ["opk-deg", "opk-gon"]
# $columns = "kappa"
position_list-orientations_open = Exterior orientations may be { LIST($readings) } (columns: { $columns }); the photographs decide.
