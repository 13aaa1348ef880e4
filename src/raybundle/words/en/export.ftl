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

# $formats = ["colmap"]
export-not_one_file = Not a single file: format { LIST($formats, most: 20) }.
    .why = Several formats are written at once as files of one name.
    .do = Convert to this format alone.

# $formats = ["bingo", "patb"]
export-same_file = Two of the formats { LIST($formats, most: 20) } have the same file name.
    .do = Convert to one of them alone.

# $format = "dxf"
export-format_failed = Format { $format } is not written:

# $n = 1
# $written = 2
# $places = ["out.svg", "out.csv"]
export-formats_failed = Formats that cannot be written: { $n }; written: { $written ->
        [0] none
       *[other] { LIST($places, most: 20) }
     }.
    .do = Correct the causes below, then convert to these formats again.
