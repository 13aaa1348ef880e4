camera_constant = Caméra { $camera } : la distance principale n'est pas donnée ; la valeur approchée est { NUM($c_mm, digits: 4) } mm.
