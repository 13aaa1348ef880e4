image_point-out_of_range = { $x }, { $y } sind keine Bildkoordinaten in { $unit ->
        [mm] mm
       *[um] µm
     } (größter Wert { $largest } { $unit ->
        [mm] mm
       *[um] µm
     }).
    .do = Die Einheit prüfen.

image_point-sigma_not_positive_px = Die Standardabweichung der Bildpunkte ist { $sigma_px } px.
    .do = Einen Wert über 0 angeben.

image_point-covariance_not_positive = Bild { $image }, Punkt { $point }: Die Kovarianzmatrix ist nicht positiv definit.
    .do = sx, sy und sxy dieses Bildpunkts korrigieren.

image_point-far_off = Punkt { $point } im Bild { $image } weicht um { PERCENT($share) } % der Diagonale ab (Grenze { PERCENT($limit) } %).
