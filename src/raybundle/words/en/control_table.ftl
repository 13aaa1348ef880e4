# $table = "control.csv"
control_table-no_coordinates = { $table }: no row has a coordinate.
    .do = Write columns point, X, Y, Z; optional sX, sY, sZ, role.

# $table = "control.csv"
# $point = "P1"
control_table-point_twice = { $table }: point { $point } occurs more than once.
    .do = Keep one row of it.

# $table = "control.csv"
# $detail = "unexpected end of data"
control_table-not_readable = { $table } cannot be read as a table ({ $detail }).
    .do = Check that it is a CSV table.
