network-covariance_not_positive = Netz { $network }: Die Kovarianzmatrix der { $n } Punkte ist nicht positiv definit.
    .why = Der kleinste Eigenwert der Korrelationen ist { $least } (Grenze { $limit }); ein Netz ohne Datum hat eine singuläre Kovarianzmatrix.
    .do = Die Kovarianzen der Datumspunkte ergänzen oder die Werte mit zehn Stellen schreiben.

network-point_given_twice = Punkt { $point } steht in coordinates.csv (Netz { $network }) und als Passpunkt mit Standardabweichungen in points.csv.
    .why = Seine Koordinaten würden doppelt gezählt.
    .do = Ihn aus einer der beiden Dateien löschen.
