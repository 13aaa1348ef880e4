geo_txt-empty = The file is empty.
    .do = Write the coordinate system in the first line, then a line for each photograph.

# $value = "'8.25'"
# $example = "8.25.jpg 8.25 47.5 450"
geo_txt-name_is_number = { $value } is a number; the first column is the name of a photograph.
    .do = Write lines like { $example }.
