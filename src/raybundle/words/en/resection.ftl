# $n = 2
resection-too_few_points = { $n } points are given; a resection needs three.
    .do = Measure more points.

resection-in_line = The points of the resection are on one line.
    .do = Measure a point off the line.

# $limit_px = 4.0
resection-no_fit = No orientation fits four of the points within { $limit_px } px.
    .do = Check the names of the points.

resection-no_solution = No orientation projects the points to where they were measured.
    .do = Check the names of the points.
