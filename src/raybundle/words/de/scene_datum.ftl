scene_datum = { $system } hat ein anderes Datum als die Szenen (WGS 84): { NUM($off_m, decimals: 2) } m auf 10 km.
    .why = Koordinaten wurden ohne Gitter nach WGS 84 transformiert; die Genauigkeit dieser Transformation begrenzt die absolute Lage.
    .do = Für eine bessere Lage die Passpunkte vorher mit dem amtlichen Gitter nach WGS 84 transformieren.
