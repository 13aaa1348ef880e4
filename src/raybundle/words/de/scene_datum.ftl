scene_datum = { $system } hat ein anderes Datum als die Szenen (WGS 84): { NUM($off_m, decimals: 2) } m auf 10 km.
    .why = Koordinaten wurden mit der besten Transformation von PROJ ohne Gitter nach WGS 84 überführt.
