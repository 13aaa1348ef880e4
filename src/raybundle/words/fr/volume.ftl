volume-base_unknown = { OPTION("above", $value) } n'est ni une altitude, ni un dossier de surface, ni { $rim }.

volume-rim_needs_outline = Une base le long du bord demande un contour.

volume-filled_share = { PERCENT($share) } % de la surface ont été comblés (limite { $limit_percent } %).

volume-no_height = { PERCENT($share) } % de la surface n'ont pas d'altitude ({ $n } cellules).
