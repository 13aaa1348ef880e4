fundamental-too_few_points = { $n } homologe Punkte sind gegeben; eine Fundamentalmatrix braucht { $least }.
    .do = Mehr homologe Punkte messen.

fundamental-one_point = Alle Punkte des ersten Bildes sind identisch.
    .do = Andere messen.

fundamental-too_few_inliers = { $n } von { $total } homologen Punkten passen zu einer Fundamentalmatrix; nötig sind { $least }.
    .why = Die Standardabweichung ist { $sigma_px } px.
    .do = Die Zuordnung und die Standardabweichung prüfen.

fundamental-homography = Eine Homographie erklärt { PERCENT($share) } % der homologen Punkte (Grenze { PERCENT($limit) } %).
    .why = Das Objekt ist eine Ebene, oder beide Bilder wurden vom selben Standpunkt aufgenommen.
    .do = Punkte verschiedener Tiefe messen oder ein anderes Bild verwenden.
