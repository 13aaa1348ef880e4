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
