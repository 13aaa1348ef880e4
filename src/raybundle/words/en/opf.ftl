# $n = 2
opf-file_count = The folder has { $n } .opf files; exactly one is needed.
    .do = Give the file to be read.

# $part = "input-cameras"
opf-not_calibrated = The project has no { $part }.
    .do = Give a calibrated project.

# $path = "'../a.json'"
opf-path_outside = { $path } leads out of the folder of the project.
    .do = Use relative paths within the folder.

# $camera = "17"
# $sensor = "3"
opf-unknown_camera = Camera { $camera } or its sensor { $sensor } is not in the lists.
    .do = Export the project again.

# $points = 100
# $ranges = 99
# $image_points = 400
opf-counts_differ = { $points } points, { $ranges } ranges and { $image_points } image points do not match.
    .do = Export the project again.

# $kind = "VEC3"
# $type = "5126"
opf-accessor_type = The accessor has type { $kind } of { $type }; another is needed.
    .do = Export the project again.

# $n = 1000
# $size_bytes = 120
opf-accessor_size = The accessor announces { $n } elements; its buffer has { $size_bytes } bytes.
    .do = Get the complete project.

opf-ranges_overlap = The ranges of image points overlap.
    .do = Export the project again.

opf-not_finite = A coordinate is not finite.
    .do = Export the project again.
