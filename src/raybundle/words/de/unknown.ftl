unknown-image = Äußere Orientierung des Bildes { $image }: { $part ->
        [rotation_x] Drehung um x
        [rotation_y] Drehung um y
        [rotation_z] Drehung um z
       *[other] { $part }
     }

unknown-parameter = { $symbol } der Kamera { $camera }

unknown-point = Punkt { $point }: { $axis }

unknown-other = Unbekannte { $number }
