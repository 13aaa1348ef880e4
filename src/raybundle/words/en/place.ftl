# $line = 12
place-line = line { $line }

# $row = 12
place-row = row { $row }

# $column = "X"
place-column = column { $column }
