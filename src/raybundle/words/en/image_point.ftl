# $x = 1200.0
# $y = 30.0
# $unit = "mm"
# $largest = 1000.0
image_point-out_of_range = { $x }, { $y } are no image coordinates in { $unit ->
        [mm] mm
       *[um] µm
     } (largest { $largest } { $unit ->
        [mm] mm
       *[um] µm
     }).
    .do = Check the unit.

# $sigma_px = 0.0
image_point-sigma_not_positive_px = The standard deviation of the image points is { $sigma_px } px.
    .do = Give a value above 0.

# $image = "IMG_1"
# $point = "P7"
image_point-covariance_not_positive = Image { $image }, point { $point }: the covariance matrix is not positive definite.
    .do = Correct sx, sy and sxy of this image point.

# $point = "P7"
# $image = "IMG_1"
# $share = 0.3
# $limit = 0.05
image_point-far_off = Point { $point } in image { $image } deviates by { PERCENT($share) } % of the diagonal (limit { PERCENT($limit) } %).
