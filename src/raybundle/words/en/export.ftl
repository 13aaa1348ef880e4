export-no_csv_name = The name of a table of points ends in .csv.
    .do = Choose such a name.

export-no_points = No point is measured by hand, so there is nothing to export.
    .do = Mark a point first.

# $kind = "point"
# $name = "'#1'"
export-name_not_possible = { $kind ->
        [image] Image
       *[point] Point
     } { $name } cannot be written to gcp_list.txt.
    .do = Export a CSV table.

export-no_control = No control or check point with X, Y and Z is marked, so there is nothing to export.
    .do = Mark such a point first.
