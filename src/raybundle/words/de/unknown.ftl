unknown-image = Bild { $image }: { $part ->
        [rotation_x] Die Drehung um x
        [rotation_y] Die Drehung um y
        [rotation_z] Die Drehung um z
        *[other] Die Koordinate { $part } des Projektionszentrums
    } ist nicht bestimmt.

unknown-parameter = Der Parameter { $symbol } der Kamera { $camera } ist nicht bestimmt.

unknown-point = Punkt { $point }: Die Koordinate { $axis } ist nicht bestimmt.

unknown-other = Die Unbekannte { $number } ist nicht bestimmt.
