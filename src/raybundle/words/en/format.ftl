# $format = "xyz"
# $known = ["bundler", "colmap"]
format-unknown = Format { $format } is unknown.
    .do = Use one of { LIST($known, most: 40) }.

# $format = "las"
# $known = ["bundler", "colmap"]
format-only_written = Format { $format } can be written, but not read.
    .do = Use one of { LIST($known, most: 40) }.

# $format = "mrk"
format-only_read = Format { $format } can be read, but not written.
    .do = Choose another format.

# $format = "kml"
format-needs_crs = Format { $format } needs the coordinate system of the block.
    .do = Give { OPTION("crs", "EPSG:25832") }, and { OPTION("frame_origin", "E", "N", "H") } if the block is in a local frame.

# $format = "las"
format-free_scale = Format { $format } has coordinates in metres, but the scale of the block is not determined.
    .do = Adjust with a scale bar, two control points or observed positions, or give { OPTION("free_scale", "True") }.

# $deviation_px = 0.45
# $limit_px = 0.1
# $undistort = true
format-camera_deviation = A camera of this format deviates by up to { $deviation_px } px from the original (limit { $limit_px } px).
    .do = { $undistort ->
        [yes] Undistort the photographs ({ OPTION("photos", "FOLDER") } { OPTION("undistort", "inside") }), choose another format,
       *[no] Choose another format,
     } or accept it with { OPTION("approximate", "True") }.

# $format = "BINGO"
# $files = ["image.dat", "itera.dat"]
format-needs_folder = { $format } is a folder with the files { $files }.
    .do = Give the folder.

# $format = "DXF"
# $system = "WGS 84"
format-degrees = { $format } has coordinates as lengths; { $system } is in degrees.
    .do = Give a projected system of the same datum, such as { OPTION("crs", "EPSG:32632") }.

# $format = "colmap"
# $known = ["dxf", "svg"]
format-not_in_plane = { OPTION("within", flag: "in") } belongs to drawings; format { $format } is none.
    .do = Leave it out, or use one of { LIST($known, most: 20) }.

# $format = "colmap"
format-no_tables = { OPTION("tables") } belongs to block folders; format { $format } is none.
    .do = Leave it out.

format-csv = There is no format csv.
    .why = A block folder (format block) and a result folder consist of CSV tables: images.csv, points.csv, observations.csv.
    .do = Copy the table that you need.

# $format = "bingo"
# $suffix = ".dat"
format-file_suffix = Format { $format } is a file with the ending { $suffix }.
    .do = Give a name that ends in { $suffix }.

# $format = "colmap"
# $scenes = "scene_1, scene_2"
# $whole = ["block", "rpc"]
# $points = ["dxf", "geopackage", "las"]
format-no_scenes = Format { $format } has no satellite scenes; the block has { $scenes }.
    .do = Choose { $whole } for the scenes, or one of { LIST($points, most: 20) } for the points.

# $names = ["bingo", "patb"]
format-ambiguous = The file fits several formats: { $names }.
    .do = Give one of them: { OPTION("read_as", flag: "from") }.

# $known = ["block", "bingo", "colmap"]
format-not_recognised = The format is not recognised.
    .do = Give { OPTION("read_as", flag: "from") }, one of { LIST($known, most: 60) }.
