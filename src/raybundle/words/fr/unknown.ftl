unknown-image = Orientation externe de l'image { $image } : { $part ->
        [rotation_x] rotation autour de x
        [rotation_y] rotation autour de y
        [rotation_z] rotation autour de z
       *[other] { $part }
     }

unknown-parameter = { $symbol } de la caméra { $camera }

unknown-point = Point { $point } : { $axis }

unknown-other = Inconnue { $number }
