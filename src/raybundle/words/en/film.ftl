# $x_mm = 106000.0
# $y_mm = 0.0
# $largest_mm = 500.0
film-mark_outside_camera = { $x_mm }, { $y_mm } mm is outside any camera (largest { $largest_mm } mm).
    .do = Give millimetres.

# $mark = "'F9'"
# $known = ["F1", "F2"]
film-mark_not_calibrated = Mark { $mark } has no calibrated position.
    .do = Correct its name: { LIST($known, most: 8) }, or add it to the certificate.

# $x_px = 1000000000.0
# $y_px = 0.0
# $largest_px = 1000000.0
film-position_outside_scan = { $x_px }, { $y_px } px is outside any scan (largest { $largest_px } px).
    .do = Correct the measurement.

# $image = "1001"
# $pixel_mm = 12.0
film-pixel_size = Image { $image }: a scanner pixel of { $pixel_mm } mm is not possible.
    .do = Give the size in mm.

# $image = "1001"
# $n = 2
# $model = "affine"
# $needed = 3
film-too_few_marks = Image { $image } has { $n } marks; the transformation { $model } needs { $needed }.
    .do = Measure more marks, or use a simpler transformation.

# $image = "1001"
# $model = "affine"
film-marks_in_line = Image { $image }: the marks lie on a line or in one place.
    .why = The transformation { $model } is not determined.
    .do = Measure marks that are spread over the image.

# $n = 3
# $needed = 4
film-too_few_crosses = The reseau has { $n } crosses; a correction needs { $needed }.
    .do = Measure more crosses, or leave the reseau out.

# $image = "1001"
film-no_marks = Image { $image } has points, but no marks.
    .do = Measure its fiducial marks.

# $image = "1001"
film-marks_implausible = Image { $image }: no film has the deformation that these marks show.
    .why = The transformation would distort all image points, so this scan is not transformed.
    .do = Correct the marks as described below, then transform the scans again.

# $image = "1001"
# $model = "affine"
film-no_transformation = Image { $image }: no { $model } transformation fits the marks.
    .do = Correct the marks as described below, then transform the scans again.

# $worst_mm = 3.2
# $limit_mm = 1.0
film-residuals = Residuals of the fiducial marks reach { $worst_mm } mm after the transformation (limit { $limit_mm } mm).
    .do = Compare names, measured positions and calibrated positions of the marks.

# $ratio = 1.2
# $limit = 1.05
film-stretch = The marks would stretch the film { $ratio } times as much along one axis as along the other (limit { $limit }).
    .do = Compare names, measured positions and calibrated positions of the marks.

# $shear_deg = 3.2
# $limit_deg = 1.0
film-shear = The marks would shear the film: the axes deviate by { $shear_deg }° from the right angle (limit { $limit_deg }°).
    .do = Compare names, measured positions and calibrated positions of the marks.

# $pairs = ["F1 - F2"]
film-marks_exchanged = The names of two marks are probably interchanged: { $pairs }.
    .do = Interchange these names.

# $mark = "F3"
# $offset_mm = 11.3
film-wrong_mark = Mark { $mark } is { $offset_mm } mm off the position that the others give.
    .do = Measure it again, or correct its calibrated position.

film-several_wrong_marks = More than one mark is wrong.
    .do = Compare names, calibrated and measured positions.

film-camera_missing = Scans of film need a calibrated camera.
    .do = Give its certificate: { OPTION("calibration", "CAMERA") }.

# $n = 2
film-scans_not_transformed = Scans that cannot be transformed: { $n }. Nothing is written.
    .do = Correct the marks of these scans as described below, or delete their rows.

# $n = 2
film-one_camera = Cameras given: { $n }; scans of film need exactly one, the camera of the film.
    .do = Give one camera: { OPTION("calibration", "CAMERA") }.

film-as_many_marks = As many marks as unknowns: a wrong mark is not noticed.
    .do = Measure more marks, or choose a simpler transformation.

# $image = "a.tif"
film-mirrored = Image { $image } is mirrored.
    .why = The film was scanned from behind, or two opposite marks are exchanged.
    .do = Scan the film from its front, or exchange the two marks.

# $image = "a.tif"
# $limit = 0.01
film-shrinkage = Image { $image }: the film would have shrunk by more than { PERCENT($limit) } %.
    .why = No film does.
    .do = Check { OPTION("pixel_mm") }.

# $image = "a.tif"
# $sigma0 = 2.4
film-residuals_enlarged = Image { $image }: residuals of the marks are { NUM($sigma0, digits: 3) } times as large as stated.
    .why = Standard deviations are enlarged by this factor.

# $image = "a.tif"
# $marks = ["3", "7"]
film-suspects = Image { $image }: marks may be wrong: { $marks }.
    .do = Measure these marks again.
