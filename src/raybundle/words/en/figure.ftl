# $type = "Axes"
figure-wrong_type = figure is of type { $type }, not Figure or SubFigure.
    .why = Each figure has several axes.
    .do = Give a Figure or SubFigure of matplotlib.

figure-no_image_points = No image point took part in the adjustment, so there is nothing to draw.
    .do = Choose another figure, or adjust a block with image points.

# $camera = "d5100"
# $known = ["d850", "rx100"]
figure-camera_without_points = Camera { $camera } has no image points in the adjustment.
    .do = Give one of { LIST($known, most: 20) }.

figure-no_control = There are neither control points with standard deviations nor check points; nothing can be drawn.
    .do = Give control points with standard deviations, or check points, and adjust again.

# $name = "camera d5100"
figure-no_distortion = { $name } has neither distortion nor standard deviations, so there is nothing to draw.
    .do = Choose another camera, or adjust with free distortion parameters.

figure-no_camera = No camera of the adjustment has a distortion that can be drawn.
    .why = Scenes and instruments have no distortion; parameters of single images have no common figure.
    .do = Choose another figure.

# $name = "d5100"
# $known = ["d850", "rx100"]
figure-none_of_camera = There are no figures of the interior orientation { $name }.
    .do = Give one of { LIST($known, most: 20) }.

figure-no_network = No object point with rays has coordinates, so there is no network to draw.
    .do = Measure points in two photographs or more, and adjust again.

figure-no_redundancy_numbers = The adjustment has no redundancy numbers.
    .why = It was made without statistics.
    .do = Adjust with AdjustmentOptions(statistics=True).

# $type = "Oriented"
figure-no_adjustment = The argument is of type { $type }, not Adjustment.
    .do = Give the result of adjust, or the attribute .adjustment of the result of orient, calibrate or measure.
