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

# $table = "ephemeris"
# $times = 10
# $n = 9
trajectory-count = Table { $table }: { $times } times and { $n } entries.
    .do = Give as many of both, at least two.

# $table = "ephemeris"
trajectory-not_finite = Table { $table } has a time or value that is not a finite number.
    .do = Correct the table.

# $table = "ephemeris"
# $time_s = 12.0
# $entry = 5
# $before_s = 13.0
trajectory-time_order = Table { $table }: time { $time_s } s (entry { $entry }) follows { $before_s } s.
    .do = Sort the entries by time and delete repeated times.

trajectory-zero_quaternion = A quaternion of the attitude has length zero.
    .do = Correct the table of attitudes.

# $table = "ephemeris"
# $start_s = 0.0
# $end_s = 10.0
# $first_s = 5.0
# $last_s = 15.0
trajectory-not_covered = Table { $table } covers { $start_s } to { $end_s } s, but the lines { $first_s } to { $last_s } s.
    .why = The table is cut off, or its start time belongs to another scene.
    .do = Get the complete table of this scene.

# $table = "attitude"
# $gap_s = 12.0
# $start_s = 4.0
# $end_s = 16.0
# $usual_s = 0.25
trajectory-gap = Table { $table } has a gap of { $gap_s } s within the image, from { $start_s } to { $end_s } s.
    .why = The usual interval is { $usual_s } s.
    .do = Get a complete table.

# $name = "position_degree"
# $degree = 5
trajectory-degree = { $name } = { $degree } is not possible.
    .do = Give 0, 1, 2, or -1 for none.

# $needed = 12
# $shape = [9]
trajectory-parameter_count = Correction parameters have shape ({ $shape }); { $needed } are needed.
    .do = Give one value for each parameter.

# $table = "ephemeris"
# $entry = 3
# $moved = 7590
# $stated = 12
trajectory-velocity_contradicts = Table { $table }, entry { $entry }: velocity { NUM($stated, digits: 4) } m/s; positions change by { NUM($moved, digits: 4) } m/s.
    .do = Check units, signs and columns of the velocities.

# $readings = ["opk-deg", "opk-gon"]
# $first = "opk-deg"
trajectory-undecided = The file does not determine the convention of these columns: possible are { $readings }.
    .do = Name the columns with their unit (omega_gon), or give { OPTION("attitudes", $first) }. Four photographs or more decide.

# $seconds = 5400.0
# $limit_s = 600.0
trajectory-scenes_apart = Scenes of one trajectory are { NUM($seconds, digits: 4) } s apart; { NUM($limit_s, digits: 3) } s are possible.
    .do = Give scenes of another orbit or strip a trajectory of their own.

# $name = "'east'"
trajectory-no_scene = No camera names the trajectory { $name }.
    .do = Write trajectory = { $name } into the tables of its cameras, or delete it.
