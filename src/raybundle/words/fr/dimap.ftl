dimap-no_model = Le fichier ne contient ni Global_RFM ni Refined_Model.

dimap-image_size = Le domaine de validité donne une image de { $width_px } x { $height_px } px.

dimap-no_attitude = L'attitude n'a ni Quaternion_List ni Polynomial_Quaternions.

dimap-no_bias_prior = La précision de l'orbite n'est pas donnée dans DIMAP ; le biais n'a pas d'écart-type a priori.

dimap-corrections = La réfraction { $refraction ->
     [yes] est appliquée
     *[no] n'est pas appliquée
    }, l'aberration { $aberration ->
     [yes] est appliquée
     *[no] n'est pas appliquée
    }, selon le fichier.
