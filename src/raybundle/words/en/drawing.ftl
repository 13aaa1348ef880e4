drawing-no_source = There is nothing to draw.
    .do = Give a picture to scale, a result folder or a project.

# $other = "south.toml"
drawing-planes_differ = The picture lies in another plane or coordinate system than { $other }.
    .do = Draw pictures of one plane on a sheet.

drawing-no_extent = There are no points or lines to draw.
    .do = Give { OPTION("extent", "LEFT", "BOTTOM", "RIGHT", "TOP") }.

# $width = 12.5
# $height = 0.0
drawing-no_area = The area to draw is { $width } x { $height }; both must be above 0.
    .do = Correct { OPTION("extent") }.

drawing-several_results = Points and lines of one result can be drawn; this is the second.
    .do = Give one result.

# $setting = "plane"
drawing-plane_of_picture = { OPTION($setting) } defines the plane of a result; a picture has its own plane.
    .do = Leave it out, or rectify the picture with it.

# $grid = 0.1
# $apart_mm = 1.0
# $least_mm = 10.0
# $needed = 2.0
drawing-grid_too_dense = Lines of the grid { $grid } would be { NUM($apart_mm, digits: 2) } mm apart on paper (at least { $least_mm } mm).
    .do = Use { OPTION("grid", $needed) }.

# $width_m = 24.0
# $height_m = 9.5
# $paper = "A4"
# $scale = 20
# $sheets = 0
drawing-does_not_fit = The object of { $width_m } x { $height_m } m does not fit on { $paper }{ $scale ->
    [0] {" "}at any scale
   *[other] {" "}at 1:{ $scale }
}{ $sheets ->
    [0] .
   *[other] {" "}with { $sheets } sheets.
}
    .do = Use one of the remedies:

# $scale = 200
drawing-fitting_scale = A smaller scale fits: { OPTION("scale", $scale) }.

# $paper = "A0"
drawing-fitting_paper = A larger paper fits: { OPTION("paper", $paper) }.

drawing-joined_sheets = Sheets that are joined: { OPTION("several", "True") }.

drawing-title_block = Fewer words in the title block.
