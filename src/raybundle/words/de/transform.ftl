transform-wrong_shape = Feld { $name } einer Transformation: Dimension ({ $shape }) oder nicht endliche Werte.
    .do = Endliche Zahlen der Dimension ({ $needed }) angeben.

transform-observed_unknown = observed = { $value } ist unbekannt.
    .do = "follow" oder "stay" angeben.

transform-scale_not_positive = Der Maßstabsfaktor der Transformation ist { $scale }.
    .do = Einen Wert über 0 angeben.

transform-translation_not_finite = Die Translation der Transformation ist { $translation }.
    .do = Drei endliche Zahlen angeben.

transform-scene = Die Satellitenszene { $scene } lässt sich nicht transformieren.
    .why = Das Modell der Szene liefert geographische Länge, Breite und Höhe.
    .do = Einen Block ohne Satellitenszenen transformieren.

transform-geodetic_frame = Das Objektsystem hat einen festen Ort auf der Erde und lässt sich nicht transformieren.
    .do = Den Ort aus dem Block entfernen (place=None).

transform-rotation_not_orthogonal = Die Drehmatrix der Transformation ist nicht orthogonal: R R' weicht um { NUM($off, digits: 2) } von 1 ab (Grenze { $limit }).
    .do = Eine orthogonale Matrix mit Determinante +1 angeben.

transform-rotation_mirrored = Die Drehmatrix der Transformation enthält eine Spiegelung.
    .do = Eine orthogonale Matrix mit Determinante +1 angeben.

transform-sigmas_correlated = { $name } lässt sich nicht transformieren: Standardabweichungen von { $parameters } würden korreliert.
    .do = Gleiche Standardabweichungen verwenden oder ohne Drehung transformieren.

transform-partly_free = { $name } lässt sich nicht drehen: Von { $parameters } sind einige fest, andere frei.
    .do = Alle freigeben oder alle festhalten.

transform-calibration_incomplete = { $name } lässt sich nicht drehen: Die Kalibrierung hat keinen Wert für { $parameter }.
    .do = Mit diesem Parameter kalibrieren oder ohne Drehung transformieren.

transform-row_not_possible = { $row } kann nicht transformiert werden:
    .do = Diese Zeile vor der Transformation löschen oder das jetzige Koordinatensystem beibehalten.

transform-not_given = Eine Koordinate fehlt, die die Drehung mit den gegebenen verbindet.

transform-would_correlate = Ihre Koordinaten wären korreliert, was Standardabweichungen allein nicht angeben.

transform-coefficients = Ihre Korrelationskoeffizienten sind nicht die beobachteter Größen.
    .why = Ihre Matrix ist nicht positiv definit, oder eine Standardabweichung fehlt.

transform-not_observed = { $kind ->
        [coordinate] Eine Koordinate
        *[angle] Ein Winkel
    } wurde nicht beobachtet, aber die Drehung verbindet sie mit den beobachteten.
    .do = Eine Standardabweichung angeben oder die Zeile weglassen.

transform-too_correlated = Ihre { $kind ->
        [coordinate] Koordinaten
        *[angle] Winkel
    } wären zu eng korreliert: kleinster Eigenwert { NUM($eigenvalue, digits: 2) } (Grenze { $limit }).
    .why = Ihre Standardabweichungen sind zu verschieden.

transform-phi_near_right_angle = phi läge nahe einem rechten Winkel.
    .why = Dort drehen omega und kappa um dieselbe Achse.

transform-vertical_turned = Die Zeile bezieht sich auf die Lotrichtung, die um { $angle_deg }° gedreht wird.

transform-heights_tilted = Instrumenten- und Zielhöhen liegen in der Lotrichtung, die gekippt wird.
