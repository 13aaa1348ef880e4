# $value = "'500000.1235400000.123'"
exterior_list-touching = Two numbers touch: { $value }.
    .why = No line of the file separates them by a blank.
    .do = Write the list with wider columns or with semicolons.

# $n = 9
# $needed = [7, 13]
exterior_list-columns = A line without column names has { $n } columns; { LIST($needed) } are understood.
    .do = Add a first line of names, such as name X Y Z omega phi kappa.

# $value = 512.3
# $largest = 400
exterior_list-angle_size = { $value } is no angle in degrees, gon or radians (largest: { $largest }).
    .do = Correct the number or the names of the columns.
