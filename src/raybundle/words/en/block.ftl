# $block = "facade"
block-no_oriented_image = Block { $block } has no oriented image.
    .do = Orient or adjust it first.

# $block = "facade"
block-nothing_to_write = Block { $block } has neither points nor photographs; there is nothing to write.
    .do = Give a block with points or photographs.

block-is_a_file = This is a file, not the folder of a block.
    .do = Give a folder with block.toml, images.csv and observations.csv.

# $block = "result/block"
block-result_folder = This is the folder of a result, not of a block.
    .do = Give its block, { $block }.

block-no_block_toml = The folder has no block.toml; it is not a block.
    .do = Give a folder with block.toml, images.csv and observations.csv.

block-file_missing = The file is missing; a block needs it.
    .do = Add the file, or give another folder.

# $meant = "points.csv"
block-file_name = The file is not read under this name.
    .do = Rename it to { $meant }, or move it elsewhere.

block-observations_not_parquet = The table is read at once; a block larger than memory needs Parquet.
    .do = Write the block with tables="parquet" (write_block).

block-no_camera = The block has no camera.
    .do = Add a table [cameras.ID] for each camera.

# $block = "pair"
block-no_scene = Block { $block } has no satellite scene; RPCs are written for scenes only.
    .do = Choose another format, or give a block with satellite scenes.

# $block = "facade"
# $name = "points.xyz"
# $type = "<U4"
block-not_numbers = Block { $block }: { $name } holds { $type }; it must hold numbers.
    .do = Convert { $name } to an array of numbers, with nan for unknown values.

# $block = "facade"
# $name = "images.camera"
# $type = "float64"
block-not_whole_numbers = Block { $block }: { $name } holds { $type }; positions must be whole numbers.
    .do = Convert { $name } to an array of integers.

# $block = "facade"
# $name = "images.camera"
# $row = 3
# $position = 9
# $last = 1
block-position_out_of_range = Block { $block }: { $name }[{ $row }] is { $position }; positions run from 0 to { $last }.
    .do = Correct this position, or add the missing row to the table it refers to.

# $block = "facade"
# $name = "points.xyz"
# $shape = [4, 3]
# $type = "ndarray"
# $found = [4, 2]
block-shape = Block { $block }: { $name } must be an array of shape ({ $shape }).
    .why = The present value is of type { $type } with shape ({ $found }).
    .do = Give one row for each row of the table, in an array of this shape.

# $kind = "observation"
# $image = "IMG_1"
# $point = "P7"
# $number = 1e+30
# $limit = 1000000000000000.0
block-number_too_large = { $kind ->
        [image] Image { $image }
        [point] Point { $point }
       *[observation] Image { $image }, point { $point }
     }: { $number } is not a number up to { $limit } in size.
    .do = Check its unit, or leave it out.

# $image = "IMG_1"
# $points = ["P1", "P2"]
# $camera = "d5100"
# $parameters = ["c"]
block-single_image = Image { $image } alone does not determine object points { $points }.
    .why = Without enough control its exterior orientation and the parameters of camera { $camera } ({ LIST($parameters, most: 20) }) are not determined either.
    .do = Add images from other stations, or give control points for a resection.

# $parts = 2
# $n = 1
block-parts_without_datum = The block has { $parts } parts without common tie points; { $n } { $n ->
        [one] has
       *[other] have
     } no datum.
    .do = Measure points that join the parts, give each part control, or adjust the parts separately.

# $images = ["IMG_1", "IMG_2"]
# $n = 1
# $part = "scale"
block-open_part = Not determined for images { LIST($images, most: 10) }: { datum-part }.

# $optional = true
block-scale_free = The scale of the block is not determined: no length fixes it.
    .do = Give the adjustment a scale bar, two control points or observed positions{ $optional ->
        [yes] , or use { OPTION("free_scale", "True") } for a picture without unit
       *[no] { "" }
     }.

block-not_adjusted = Images have no orientation, or points no coordinates: the block is not adjusted.
    .do = Adjust it, and give the result.

# $block = "bridge"
block-heights_defined = Block { $block } already defines the reference of its heights.
    .do = Omit { OPTION("undulation") }.

# $block = "bridge"
block-place_defined = Block { $block } already defines the place of its frame on the earth.
    .do = Omit { OPTION("crs") }, or give { OPTION("frame_origin") } too.

# $block = "part"
# $unit = "mm"
# $system = "EPSG:25832"
block-origin_missing = Block { $block } has lengths in { $unit }, so its coordinates are not those of { $system }.
    .do = Give { OPTION("frame_origin") }.

# $block = "bridge"
block-folder_needs_observations = Block { $block } has no image observations; a block folder needs them.
    .do = Convert it to another format.
