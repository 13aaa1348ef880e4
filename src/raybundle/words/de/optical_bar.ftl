optical_bar-corrections = Refraktion wird angebracht, Aberration nicht, wie in der Ames Stereo Pipeline.

optical_bar-rotation = iR ist keine Drehung (Abweichung { NUM($deviation, digits: 2) }), oder das Bild hat nur eine Spalte.
    .do = iR und image_size korrigieren.

optical_bar-sweep = Der Schwenk reicht { NUM($degrees, digits: 3) }° von seiner Mitte weg; möglich sind { NUM($limit, digits: 2) }°.
    .do = pitch, f oder image_center korrigieren.
