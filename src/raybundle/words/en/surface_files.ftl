# $correlation = 1.2
surface_files-correlation = { $correlation } is not a correlation between 0 and 1.

# $unit = "yard"
# $known = ["m", "mm"]
surface_files-unit_unknown = The unit { $unit } of the heights is unknown.
    .do = Give one of { $known }.

# $columns = 400
# $rows = 300
# $about = "heights.toml"
# $needed_columns = 500
# $needed_rows = 300
surface_files-size_differs = The raster has { $columns } x { $rows } cells; { $about } has { $needed_columns } x { $needed_rows }.
    .do = Use the files as surface wrote them; crop or convert copies.

# $quantity = "left"
# $value = 534700.0
# $about = "heights.toml"
# $needed = 534710.0
surface_files-place_differs = The raster has { $quantity ->
        [left] its left edge at
        [top] its top edge at
        [width] a cell width of
       *[height] a cell height of
    } { NUM($value, digits: 12) }; { $about } has { NUM($needed, digits: 12) }.
    .do = Use the files as surface wrote them; crop or convert copies.

# $about = "heights.toml"
surface_files-rotated = The rows of the raster are rotated against the axes; { $about } has no rotation.
    .do = Use the files as surface wrote them; crop or convert copies.

# $system = "EPSG:25833"
# $about = "heights.toml"
# $needed = "EPSG:25832"
surface_files-system_differs = The raster is in { $system }; { $about } has { $needed }.
    .do = Use the files as surface wrote them; crop or convert copies.

# $about = "heights.toml"
surface_files-other_surface = The file belongs to another surface than { $about }: its checksum differs.
    .do = Run surface again with the same settings.

# $n = 4
surface_files-infinite_heights = { $n } { $n ->
        [one] cell has
       *[other] cells have
    } an infinite height.
    .do = Write NaN there, or run surface again with the same settings.

# $n = 4
# $cells = 1000
# $band = "sigma"
# $negative = 1
# $infinite = 1
# $zero = 1
# $missing = 1
surface_files-impossible_sigmas = { $n } of { $cells } cells with a height have an impossible standard deviation ({ $band }).
    .why = Negative: { $negative }; infinite: { $infinite }; zero: { $zero }; missing: { $missing }.
    .do = Set these heights to NaN, or run surface again with the same settings.

# $cells = 0
surface_files-block_size = The orientation of the heights has blocks of { $cells } cells.
    .do = Run surface again with the same settings.

# $nodes = [3, 4]
# $rows = 300
# $columns = 400
# $needed = [5, 6]
surface_files-node_count = The file has { $nodes } nodes; heights of { $rows } rows and { $columns } columns have { $needed }.
    .why = It belongs to another surface.
    .do = Run surface again with the same settings.

surface_files-not_finite = The file contains a value that is not a finite number.
    .do = Run surface again with the same settings.

surface_files-other_holes = The filled holes in the file belong to another surface.
    .do = Run surface again with the same settings.

# $name = "heights.tif"
surface_files-no_heights = The folder has no { $name }; no height grid was written.
    .do = Run surface with { OPTION("dsm") }.

# $dimensions = 2
surface_files-node_dimensions = The nodes have { $dimensions } dimensions; 3 or 4 are needed.
    .do = Run surface again with the same settings.

# $sigmas = "heights_sigma.tif"
# $heights = "heights.tif"
# $n = 3
# $needed = 6
surface_files-bands_differ = { $sigmas } has { $n } bands; { $needed } belong to { $heights }.
    .do = Run surface again with the same settings.

# $unit = "m"
# $other = "april"
# $other_unit = "free"
surface_files-units_differ = Units differ: { $unit ->
        [free] free scale
       *[other] { $unit }
    } here, { $other_unit ->
        [free] free scale
       *[other] { $other_unit }
    } in { $other }.
    .do = Use surfaces of results with the same unit.

# $cell = 0.05
# $other = "april"
# $other_cell = 0.5
surface_files-cells_differ = The surface has cells of { $cell }, { $other } of { $other_cell }.
    .do = Make both with cells of one size.

# $name = "nodes"
surface_files-entry_missing = The file has no entry { $name }.
    .do = Run surface again with the same settings.

surface_files-damaged = The file is damaged.
    .do = Run surface again with the same settings.

# $system = "EPSG:25832"
# $datum = "unknown"
# $other_system = "EPSG:7837"
# $other_datum = "DHHN2016 height (EPSG:7837)"
surface_files-vertical_datums_differ = Vertical datums differ: { $system ->
    [none] one surface
   *[other] { $system }
} ({ $datum ->
        [unknown] no vertical datum
        [ellipsoid] ellipsoidal heights
       *[other] { $datum }
    }), { $other_system ->
    [none] one surface
   *[other] { $other_system }
} ({ $other_datum ->
        [unknown] no vertical datum
        [ellipsoid] ellipsoidal heights
       *[other] { $other_datum }
    }).
    .why = Differences of these heights would contain the difference of the datums.
    .do = Make both surfaces from results in one system of plan and heights: { OPTION("crs", "EPSG:PLAN+HEIGHT") } of orient.

# $map = true
# $other = "april"
surface_files-one_in_map = { $map ->
        [yes] This surface is in a map, { $other } on a plane of the object
       *[no] This surface is on a plane of the object, { $other } in a map
    }.
    .why = Their heights have different references.
    .do = Make both surfaces in one map, or above the same plane with the same control.

# $system = "EPSG:25832"
# $other = "EPSG:25833"
surface_files-systems_differ = The surfaces are in different coordinate systems: { $system } and { $other }.
    .do = Make both in one coordinate system.

# $other = "april"
surface_files-plane_unknown = The plane of this surface or of { $other } is not known.
    .do = Make both surfaces again, above the same plane with the same control.

# $off_cells = 12.5
# $limit_cells = 3.0
# $other = "april"
surface_files-planes_differ = The planes of this surface and of { $other } differ by { $off_cells } cells (limit { $limit_cells }).
    .why = Their heights have different references.
    .do = Make both surfaces above the same plane (points of both, or one map) with the same control.
