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
