dimap-no_model = Die Datei enthält weder Global_RFM noch Refined_Model.
    .do = Die Datei RPC_*.XML oder DIM_*.XML des Produkts angeben.

dimap-image_size = Der Gültigkeitsbereich ergibt ein Bild von { $width_px } x { $height_px } px.
    .do = FIRST_ROW, LAST_ROW, FIRST_COL und LAST_COL prüfen.

dimap-no_attitude = Die Lagewinkel stehen weder in Quaternion_List noch in Polynomial_Quaternions.
    .do = Eine vollständige Datei beschaffen oder das RPC des Produkts verwenden.

dimap-no_bias_prior = Die Genauigkeit der Bahn steht nicht in DIMAP; der Versatz hat keine A-priori-Standardabweichung.

dimap-corrections = Die Refraktion wird { $refraction ->
     [yes] angebracht
     *[no] nicht angebracht
    }, die Aberration wird { $aberration ->
     [yes] angebracht
     *[no] nicht angebracht
    }, wie in der Datei eingestellt.
