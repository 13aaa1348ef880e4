positions_axes-list = { $geographic ->
     [yes] La longitude et la latitude
     *[no] Les coordonnées est et nord
    } de { $table } semblent interverties.

positions_axes = La latitude et la longitude des positions semblent interverties ; aucune position n'est utilisée.
