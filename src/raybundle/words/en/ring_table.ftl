# $bits = 2
# $most = 24
ring_table-bits = A ring of { $bits } bits is not possible.
    .do = Give from 3 to { $most } bits.

# $value = "'a b'"
ring_table-row = { $value } is not an id and a code.
    .do = Write two whole numbers.

# $ring = 5000
# $largest = 4095
ring_table-code_out_of_range = Code { $ring } is not between 1 and { $largest }.
    .do = Correct the code, or the number of bits.

ring_table-empty = The table contains no target.
    .do = Write one target a line: its id and its code.

# $inner = 1.0
# $outer = 3.0
ring_table-ring_radii = A ring from { $inner } to { $outer } radii of the dot has no gap to the dot.
    .do = Give an inner radius of at least 1.2 and a larger outer one.

# $id = 12
ring_table-id_twice = Id { $id } occurs twice.
    .do = Delete one of the two lines.

# $ring = 129
# $id = 7
ring_table-ring_twice = The ring of code { $ring } already belongs to id { $id }.
    .do = Correct the code, or delete the line.
