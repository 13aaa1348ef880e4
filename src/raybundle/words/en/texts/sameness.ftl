# $table = "points.csv"
sameness-unlike = not the same rows: { $table }

# $n = 5
sameness-all = all { $n } tables are the same to the last bit

# $n = 1
# $of = 2
# $difference = 1e-8
# $name = "x"
# $table = "points.csv"
sameness-some = { $n } of { $of } tables are the same to the last bit, the others to { NUM($difference, digits: 1) }.
    .why = Of the largest number of a column; the largest difference is in { $name } of { $table }.
