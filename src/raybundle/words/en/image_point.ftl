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
