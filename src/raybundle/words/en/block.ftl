# $block = "facade"
block-no_oriented_image = Block { $block } has no oriented image.
    .do = Orient or adjust it first.

# $block = "facade"
block-nothing_to_write = Block { $block } has neither points nor photographs; there is nothing to write.

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
