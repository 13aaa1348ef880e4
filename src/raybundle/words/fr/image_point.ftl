image_point-out_of_range = { $x }, { $y } ne sont pas des coordonnées image en { $unit ->
        [mm] mm
       *[um] µm
     } (maximum { $largest } { $unit ->
        [mm] mm
       *[um] µm
     }).
