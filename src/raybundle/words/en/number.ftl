# $entry = "P1, X"
# $value = "nan"
number-not_finite = { $entry } is { $value }, not a finite number.
    .do = Give a number.

# $entry = "P1, sX"
# $value = -1.0
# $limit = 0.0
number-too_small = { $entry } is { $value }.
    .do = Give a value above { $limit }.

# $entry = "P1, sX"
# $value = -1.0
# $limit = 0.0
number-below = { $entry } is { $value }.
    .do = Give a value of at least { $limit }.

# $entry = "P1, X"
# $value = 1000000000000000.0
# $limit = 100000000000.0
number-too_large = { $entry } is { $value }.
    .do = Give a value of at most { $limit } in size.
