# $n = 3
# $needed = 5
# $columns = ["x", "y"]
line-too_few_words = Words in this line: { $n }; needed: { $needed }, ending with { $columns }.
    .do = Complete the line.

line-unprintable = The line contains unprintable characters.
    .do = Delete them.

line-ends_early = The line ends too early.
    .do = Complete it.

# $n = 2
line-words_left = Surplus words at the end of the line: { $n }.
    .do = Delete them.

# $n = 2
# $needed = 3
line-too_few_cells = Columns of this line: { $n }; needed: { $needed }.
    .do = Complete the line.
