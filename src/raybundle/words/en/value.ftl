# $value = "'1e30'"
# $largest = 1e+18
value-too_large = { $value } exceeds { $largest }, the largest number that is read.
    .do = Correct the number or its unit.

# $value = "'nan'"
value-not_finite = { $value } is not a finite number.
    .do = Give a finite number.

# $value = "'abc'"
value-not_a_number = { $value } is not a number.
    .do = Give a number.

# $value = "1.5"
# $least = 1
# $most = 10000
value-not_whole = { $value } is not a whole number from { $least } to { $most }.
    .do = Give a whole number in this range.

# $value = "12"
value-no_text = { $value } is not a printable text.
    .do = Give a text in quotes, without control characters.

value-no_table = A table or object of named values is expected here.

value-no_list = A list is expected here.

# $name = "'focal'"
value-key_missing = Entry { $name } is missing.
    .do = Add it, or check that the file is complete.

# $n = 2
# $needed = 3
value-count = Number of values: { $n }; needed: { $needed }.
    .do = Give as many values as needed.

# $value = "'1.5'"
value-no_whole_number = { $value } is not a whole number, or too large.
    .do = Give a whole number.

# $value = "'omni'"
# $known = ["frame", "fisheye"]
value-not_supported = { $value } is not supported.
    .do = Use one of { LIST($known, most: 20) }.

# $value = "'maybe'"
value-no_truth_value = { $value } is neither true nor false.
    .do = Write true or false.

value-list_empty = The list is empty.
    .do = Check that the file is complete.

# $value = -1.0
# $limit = 0.0
value-not_above = { $value } is not greater than { $limit }.
    .do = Correct the value.

value-zero = The value is 0.
    .do = Give a value other than 0.

# $unit = "'ft'"
# $known = ["m", "km"]
value-unit_unknown = The unit { $unit } is not supported.
    .do = Use one of { LIST($known, most: 9) }.

# $value = "'7 November'"
value-no_time = { $value } is not a date and time.
    .do = Write it like 2021-11-07T10:29:11.950343Z.

# $value = 1e+30
# $least = 1e-12
# $most = 1000000000000000.0
value-size_out_of_range = { $value } is out of range: a number is 0, or { $least } to { $most } in size.
    .do = Correct the number or its unit.

# $value = "'5 km'"
value-no_length = { $value } is not a length.
    .do = Give a length such as 5mm, 0.5cm or 0.2in.

# $value = "True"
value-no_number_or_text = { $value } is neither a number nor a text.
    .do = Give a number, or a text in quotes.

# $entry = "kind"
# $given = "round"
# $known = ["auto", "corner", "ellipse"]
value-not_one_of = { $entry } = { $given } is unknown.
    .do = Give one of { LIST($known, most: 20) }.

# $size_bytes = 480000000
# $limit_bytes = 67108864
value-table_too_large = The table, or a chunk of it, has { $size_bytes } bytes; at most { $limit_bytes } are read.
