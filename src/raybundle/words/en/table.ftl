table-more_errors = There are more errors; the rest of the file was not read.

# $n = 0
# $least = 1
table-too_few_rows = Rows of the table: { $n }; needed: { $least }.
    .do = Add rows, or delete the file if it is optional.

table-empty = The file is empty.
    .do = Write a header and rows, or delete the file if it is optional.

# $empty = false
# $limit_bytes = 1048576
table-line_too_long = This is not a table: more than { $limit_bytes } bytes { $empty ->
        [yes] of empty lines
       *[no] in one line
     }.
    .do = Export the table again.

# $header = ["A1", "1.0", "2.0"]
# $needed = ["point", "X", "Y"]
table-no_header = The first line contains values ({ LIST($header, most: 3) }), not column names.
    .do = Write a header with { LIST($needed, most: 20) }.

# $name = "'Xx'"
# $needed = ["point", "X", "Y"]
# $optional = ["sX"]
table-unknown_column = Column { $name } is unknown.
    .do = Rename or delete it; columns are { LIST($needed, most: 20) }, optional { LIST($optional, most: 20) }.

# $name = "X"
table-column_twice = Column { $name } occurs twice.
    .do = Delete or rename one.

# $names = ["Y", "Z"]
# $header = ["point", "X"]
# $needed = ["point", "X", "Y", "Z"]
table-columns_missing = Missing columns: { $names }.
    .why = The file has { LIST($header, most: 12) }.
    .do = Add them; needed are { LIST($needed, most: 20) }.

table-empty_line = The line is empty.
    .do = Delete it.

# $n = 3
# $needed = 4
# $row = "'A1;1;2'"
# $hint = "commas"
table-cell_count = Cells in this line: { $n }; columns in the header: { $needed }.
    .why = The line is { $row }.
    .do = { $hint ->
        [commas] Separate cells by commas
        [semicolons] Separate cells by semicolons, as in the header
        [tabs] Separate cells by tabs, as in the header
        [decimal_comma] Use a decimal point, not a comma
       *[none] Fill in or delete cells
     }.

# $names = ["image", "point"]
# $earlier = 7
# $rows = false
table-pair_twice = The same { LIST($names, most: 2) } are in { $rows ->
        [yes] row
       *[no] line
     } { $earlier }.
    .do = Delete one of the two rows.

# $time_s = 12.5
# $before_s = 13.0
table-time_order = Time { NUM($time_s, digits: 10) } s follows { NUM($before_s, digits: 10) } s.
    .do = Sort the rows by time and delete repeated times.

# $detail = "unexpected end of data"
table-row_unreadable = The row cannot be read ({ $detail }).
    .do = Close an open quotation mark, or check that the file is a table.

table-quote_open = A cell continues past the end of its line.
    .do = Close the open quotation mark.

# $value = "'sep=x'"
table-separator_unknown = { $value } names no separator of tables.
    .do = Separate cells by commas, semicolons or tabs.

# $later = "'1.5'"
# $first = "'2,5'"
# $first_line = 3
# $first_column = "X"
table-two_decimal_signs = Decimal signs differ: { $later } here, { $first } in line { $first_line }, column { $first_column }.
    .do = Write all numbers with one decimal sign and without thousands separators.

# $csv = "points.csv"
table-csv_and_parquet = The table exists twice: { $csv } is in the same folder.
    .do = Move one of the two files elsewhere.

# $names = ["sX"]
# $missing = ["sY", "sZ"]
table-columns_together = Columns { $names } need the columns { $missing }.
    .do = Add them, or delete { $names }.

# $choices = ["omega_deg phi_deg kappa_deg"]
table-three_angles = Three angles of one kind and one unit are needed.
    .do = Give { LIST($choices, most: 6) }, or the same with _gon or _rad.

# $grid = ["X", "Y", "Z"]
# $geographic = ["longitude_deg", "latitude_deg", "height_m"]
table-one_position = The table needs either { $grid } or { $geographic }.
    .do = Give exactly one of these groups of columns.

# $value = 12.5
# $before = 13.0
table-not_increasing = { NUM($value, digits: 10) } follows { NUM($before, digits: 10) }; the column must increase.
    .do = Sort the rows by this column and delete repeated values.

# $name = "sZ"
# $known = ["id", "x", "y"]
table-no_such_column = The table has no column { $name }.
    .do = Give one of { LIST($known, most: 40) }.
