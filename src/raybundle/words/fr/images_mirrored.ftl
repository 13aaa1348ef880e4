images_mirrored-mend = { $mend ->
     [y_up] y des points image est compté vers le haut
     [x_left] x des points image est compté vers la gauche
     [xy_negative] x et y des points image sont intervertis, avec de mauvais signes
     *[xy] x et y des points image sont intervertis
    }

images_mirrored = L'objet est une image miroir de l'orientation donnée, qui inversée s'ajuste à { NUM($misfit, digits: 2) } de son étendue.
