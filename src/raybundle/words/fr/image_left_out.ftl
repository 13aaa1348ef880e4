image_left_out = L'image { $image } est exclue de la compensation.
