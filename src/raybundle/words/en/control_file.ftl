# $name = "control.csv"
# $off_mm = 0.12
control_file-no_sigma = { $name } contains no standard deviations; { NUM($off_mm, digits: 2) } mm is assumed, as its points fit the network.
    .do = Give sX, sY, sZ if they are known.

# $n = 2
# $ids = ["A", "B"]
control_file-not_measured = { $n } control { $n ->
        [one] point was
       *[other] points were
     } not measured: { LIST($ids, most: 10) }.
    .why = The result has no coordinates of these points, and they do not control it.
    .do = Measure these points in two photographs or more, or delete them from the file.

# $name = "control.csv"
control_file-tolerance = The column tolerance of { $name } is not used: tolerances belong to nominal coordinates.
    .why = Control points are weighted by their standard deviations alone.
    .do = Give standard deviations in the columns sX, sY, sZ.

control_file-tolerance_unused = The column tolerance of the control is not used: tolerances belong to nominal coordinates.
    .do = Give standard deviations in the columns sX, sY, sZ.

# $name = "gcp_list.txt"
# $n = 3
# $words = "'extra'"
# $point = "'GCP1'"
# $line_number = 4
control_file-words_behind_names = { $name }: words after the name of the point are not read in { $n } { $n ->
     [one] line
     *[other] lines
    }.
    .why = The first are { $words } after { $point } in line { $line_number }.
    .do = If names of points contain blanks, separate columns by tabs.

# $names = ["gcp00", "gcp01"]
control_file-no_names = The file has no point names; lines with the same X Y Z are one point: { LIST($names, most: 2) } ...

# $plan = 0.01
# $height = 0.02
# $unit = "m"
control_file-sigma_assumed = Coordinates without standard deviation: { $plan }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } in plan and { $height }{ $unit ->
     [none] { "" }
     *[other] { "" } { $unit }
    } in height assumed.

# $name = "control.csv"
# $n = 6
# $height = 0.0
control_file-heights_unknown = { $name }: all { $n } heights are { NUM($height, digits: 10) } and are taken as unknown.
    .why = The points are used in plan only.
    .do = If these heights were measured, give a CSV with a column sZ.

# $name = "check.csv"
# $others = ["control.txt"]
# $system = "EPSG:32633"
control_file-system_of_others = Coordinate system of { $name }: not defined; { $system } assumed, as in { $others }.

# $name = "control.csv"
# $x = 534684.0
# $y = 5338120.0
control_file-cartesian_assumed = Coordinate system of { $name }: not defined; Cartesian coordinates in metres assumed.
    .why = Coordinates such as { NUM($x, digits: 10) }, { NUM($y, digits: 10) } seem to belong to a map.
    .do = Give { OPTION("crs", "EPSG:CODE") } if they do.

# $name = "control.csv"
# $system = "EPSG:32633"
control_file-system_given = Coordinate system of { $name }: not defined in the file; { $system } as given by { OPTION("crs") }.

# $x = 8.54123
# $y = 47.37456
control_file-degrees = Coordinates such as { NUM($x, digits: 8) }, { NUM($y, digits: 8) } seem to be longitude and latitude.
    .why = No coordinate system is given: they would count as metres.
    .do = Transform them to a map projection; `orient` also takes them with { OPTION("crs", "EPSG:4979") } (heights above the ellipsoid).
