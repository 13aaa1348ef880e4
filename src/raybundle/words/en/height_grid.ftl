# $rows = 1
# $columns = 40
height_grid-too_small = The height grid has { $rows } rows and { $columns } columns.
    .do = Give a grid of at least two rows and two columns.

# $across = [0.0, 0.0]
# $down = [0.0, -0.5]
height_grid-no_cell_area = The cells of the height grid have no area: steps { $across } and { $down } m.
    .do = Correct the cell size in the georeferencing of the grid.

height_grid-empty = The height grid contains no height: every cell is void.
    .do = Give a grid with heights.

# $name = "dtm.tif"
height_grid-no_four_cells = Height grid { $name }: no four neighbouring cells have heights.
    .why = No surface can be interpolated.
    .do = Give a grid with fewer void cells.

# $n = 12
# $total = 4000
height_grid-void_cells = { $n } of { $total } cells have no height.
    .do = Leave these cells out, or fill them.

# $other = "before.tif"
height_grid-no_common_cell = No cell has a height here and in { $other }.
    .do = Give height grids of the same area.

# $other = "before.tif"
height_grid-identical = All heights are identical to those of { $other }.
    .why = It is the same measurement.
    .do = Give another height grid.

# $model = true
height_grid-file = This is a file. A surface is needed: the folder that raybundle surface wrote.
    .why = Standard deviations and correlations of a surface are in its folder.
    .do = { $model ->
        [yes] Compare it with a surface: raybundle heights difference, or heights volume with { OPTION("above", "FILE") }.
        *[no] Give the folder.
    }
