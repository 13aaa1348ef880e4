network-covariance_not_positive = Netz { $network }: Die Kovarianzmatrix der { $n } Punkte ist nicht positiv definit.
    .why = Der kleinste Eigenwert der Korrelationen ist { $least } (Grenze { $limit }); ein Netz ohne Datum hat eine singuläre Kovarianzmatrix.
    .do = Die Kovarianzen der Datumspunkte ergänzen oder die Werte mit zehn Stellen schreiben.

network-point_given_twice = Punkt { $point } steht in coordinates.csv (Netz { $network }) und als Passpunkt mit Standardabweichungen in points.csv.
    .why = Seine Koordinaten würden doppelt gezählt.
    .do = Den Punkt aus einer der beiden Dateien löschen.

network-pair_twice = Diese zwei Punkte des Netzes { $network } stehen in einer früheren Zeile.
    .do = Eine der beiden Zeilen löschen.

network-coordinates_missing = Die Koordinaten des Punkts fehlen (point und other sind gleich).
    .do = X, Y und Z angeben.

network-coordinates_of_pair = Eine Zeile mit zwei verschiedenen Punkten hat Koordinaten.
    .do = X, Y und Z leer lassen.

network-point_without_coordinates = Netz { $network } hat keine Zeile mit den Koordinaten eines der beiden Punkte.
    .do = Eine Zeile ergänzen, in der point und other dieser Punkt sind.

network-variance_not_positive = Eine Varianz ist { $variance }; sie muss positiv sein.

network-covariance_not_symmetric = Die Kovarianzmatrix des Punkts ist nicht symmetrisch.
    .do = cXY, cXZ und cYZ korrigieren.

network-no_depth = Die Strahlen zu jedem Objektpunkt sind parallel: Das Netz hat keine Basis.
    .why = Die Aufnahmen wurden vom selben Standpunkt aufgenommen oder zeigen ein ebenes Objekt senkrecht.
    .do = Aufnahmen von anderen Standpunkten hinzufügen, mindestens ein Zehntel der Objektentfernung auseinander.
