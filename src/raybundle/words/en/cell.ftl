cell-empty = The cell is empty.
    .do = Enter a value.

# $value = "'1.234,5'"
# $plain = "1234,5"
cell-grouped_thousands = { $value } has a separator between thousands.
    .do = Write { $plain }.

# $value = "'abc'"
# $sign = "point"
cell-not_a_number = { $value } is not a number.
    .do = Write numbers with a decimal { $sign ->
        [comma] comma
       *[point] point
     }; leave unknown values empty.

# $value = "'1e-200'"
# $smallest = 1e-100
cell-counts_as_zero = { $value } counts as 0; a value above 0 is needed.
    .why = Numbers nearer to 0 than { $smallest } are read as 0.
    .do = Correct the value.

# $value = "'-1'"
cell-not_positive = { $value } is not greater than 0.
    .do = Give a value above 0.

# $value = "'-0.1'"
cell-negative_sigma = { $value } is negative; a standard deviation is 0 (fixed) or greater.
    .do = Correct the value.

# $value = "'A\\x001'"
cell-unprintable = { $value } contains unprintable characters.
    .do = Delete them.

# $value = "' A1'"
cell-no_id = { $value } is not a valid id.
    .why = An id is not empty and has no blanks at its ends.
    .do = Correct the id.

# $id = "'A1'"
# $earlier = 7
# $rows = false
cell-id_twice = Id { $id } occurs twice, first in { $rows ->
        [yes] row
       *[no] line
     } { $earlier }.
    .do = Delete one of the two rows, or rename one.

# $id = "'A9'"
# $table = "points.csv"
cell-unknown_id = { $id } is not in { $table }.
    .do = Correct it, or add it to { $table }.

# $value = 2.0
cell-not_a_flag = { $value } is neither 1 nor empty.
    .do = Write 1, or leave the cell empty.
