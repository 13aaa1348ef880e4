# $name = ".kml"
archive-file_missing = The archive has no file { $name }.
    .do = Check that it is the right file.

# $name = "doc.kml"
# $size_bytes = 90000000
# $limit_bytes = 67108864
archive-file_too_large = { $name } in the archive has { $size_bytes } bytes; at most { $limit_bytes } are read.
    .do = Simplify it.

# $detail = "File is not a zip file"
archive-not_unpacked = The archive cannot be unpacked ({ $detail }).
    .do = Copy or export the file again.
