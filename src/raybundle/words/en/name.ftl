# $name = "'a\\x1b'"
name-unprintable = { $name } is not a printable name.
    .do = Rename it.

# $kind = "image"
# $name = "'img_07'"
name-twice = { $kind ->
        [camera] Camera
        [image] Image
        [point] Point
        [rig] Rig
       *[other] Name
     } { $name } occurs twice.
    .do = Delete or rename one.

name-missing = The name is missing.
    .do = Add it to the line.

# $name = "' img'"
name-blanks = { $name } is empty or has blanks at its ends.
    .do = Rename it.
