trajectory-no_attitudes = The trajectory has no attitudes.
    .do = Use a format of positions only.

# $true_north = true
trajectory-attitude_reference = The attitudes refer to { $true_north ->
        [yes] the grid
       *[no] true north
     }; this table needs { $true_north ->
        [yes] true north
       *[no] the grid
     }.
    .do = Choose another format.

# $known = ["mrk", "geo-txt"]
trajectory-format_unknown = The format of the file is not recognised.
    .do = Begin a table with imagename,latitude,longitude,altitude, or use one of { LIST($known, most: 20) }.

# $positions = 20
# $photographs = 18
trajectory-count_differs = Positions without names: { $positions }; photographs: { $photographs }.
    .do = Give all photographs of these exposures, and no others.

# $name = "0001"
# $first = "a/DJI_0001.JPG"
# $second = "b/DJI_0001.JPG"
trajectory-position_twice = Position { $name } belongs to { $first } and to { $second }.
    .do = Give a file of its own for each flight.

# $n = 20
# $photograph = "DJI_0001.JPG"
# $name = "img_07"
trajectory-no_photograph_found = None of the { $n } photographs has a position here.
    .why = The first photograph is { $photograph }, the first name of the file { $name }.
    .do = Correct the names.

trajectory-needs_local_frame = The positions are longitude and latitude; a local frame is needed.
    .do = Give the local frame of the block.

trajectory-north_needs_frame = Attitudes relative to true north need a coordinate system.
    .do = Give the local frame of the block.

trajectory-no_crs = The file has grid coordinates without a coordinate system.
    .do = Give { OPTION("crs", "EPSG:25832") }, or the columns longitude_deg, latitude_deg, height_m.

trajectory-no_position = The file contains no position.
    .do = Check that it is the right file; a line is NAME X Y Z or NAME LATITUDE LONGITUDE HEIGHT.
