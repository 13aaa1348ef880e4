gcp_list-empty = The file is empty.
    .do = Write the coordinate system in the first line, then lines X Y Z x y image.

gcp_list-no_system = The first line does not name a coordinate system.
    .do = Write EPSG:CODE, WGS84 UTM 11N or a PROJ string there; a table with column names is a .csv file.

gcp_list-no_point = There is no point after the first line.
    .do = Add lines X Y Z x y image.

gcp_list-name_missing = This line has no point name, but others have.
    .do = Give all lines a name, or none.

# $point = "A1"
# $image = "img_07.jpg"
# $earlier = 3
# $blanks = false
gcp_list-coordinates_differ = Point { $point } has other coordinates in line { $earlier }.
    .do = Correct one of the two{ $blanks ->
        [yes] , or separate columns by tabs: the image was read as { $image }
       *[no] { "" }
     }.

# $n = 4
# $needed = ["X", "Y", "Z", "x", "y", "image"]
# $text = "'1 2 3 4'"
gcp_list-too_few_columns = The line has { $n } columns: { $text }.
    .do = Give { LIST($needed, most: 8) } and, if wanted, a name.

gcp_list-crs_missing = A gcp_list.txt needs the coordinate system of its points.
    .do = Give { OPTION("crs", "EPSG:32633") }; a PROJ string or WGS84 UTM 33N is possible, too.
