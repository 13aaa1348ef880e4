snap-no_reference = Ein Bildausschnitt braucht denselben Punkt in einem anderen Bild.
    .do = Den Punkt zuerst in einem Bild markieren.

snap-unknown_kind = Die Art { $kind } ist unbekannt.
    .do = ellipse, corner, cross, patch oder auto verwenden.

snap-image_type = In einem Bild vom Typ { $kind } und der Dimension ({ $shape }) lässt sich nicht messen.
    .do = Ein Graustufenbild mit 8 oder 16 Bit angeben.

snap-outside = x = { $x_px }, y = { $y_px } liegt außerhalb des Bildes von { $width_px } x { $height_px } px.
    .do = Eine Stelle darin angeben.

snap-reach = reach_px = { $reach_px } ist nicht möglich.
    .do = Einen Wert über 0 und höchstens { $most_px } angeben.
