image_point-out_of_range = { $x }, { $y } sind keine Bildkoordinaten in { $unit ->
        [mm] mm
       *[um] µm
     } (größter Wert { $largest } { $unit ->
        [mm] mm
       *[um] µm
     }).
    .do = Die Einheit prüfen.
