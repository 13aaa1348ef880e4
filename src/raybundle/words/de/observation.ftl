observation-covariance = Die Kovarianz { $sxy_px2 } px² liegt außerhalb ± { $limit_px2 } px², dem Produkt sx · sy.
    .do = Die Kovarianz korrigieren oder leer lassen.

observation-sigma_out_of_range = Standardabweichungen von { $sx_px } und { $sy_px } px sind nicht plausibel.
    .do = Die Standardabweichungen in px angeben.

observation-correlation_range = { $correlation } ist kein Korrelationskoeffizient: Er muss zwischen -1 und 1 liegen.
    .do = Eine Kovarianz durch beide Standardabweichungen teilen.

observation-correlation_without_sigma = Eine Korrelation von { $correlation } gehört zu einem Wert, der nicht beobachtet ist.
    .do = Die Korrelation leer lassen oder { $first } und { $second } angeben.

observation-correlations_not_possible = Die Korrelationen { $correlations } sind zusammen nicht möglich (kleinster Eigenwert { NUM($eigenvalue, digits: 2) }, Grenze { $limit }).
    .why = Die Matrix der Korrelationen ist nicht positiv definit.
    .do = Mehr Stellen angeben oder sie korrigieren.

observation-image_twice = Dieses Bild hat schon eine Zeile.
    .do = Eine der beiden Zeilen löschen.

observation-no_sigma = Kein Winkel dieser Zeile hat eine Standardabweichung.
    .do = Eine angeben oder die Zeile löschen.

observation-value_without_sigma = Ein Wert hat keine Standardabweichung oder eine Standardabweichung keinen Wert.
    .do = Beides angeben oder beides leer lassen.

observation-no_value = Die Zeile hat keinen beobachteten Wert.
    .do = Die Zeile löschen.

observation-row_refused = Diese Zeile ist nicht verwendbar: { $detail }.
    .do = Zeile berichtigen oder löschen.

observation-same_point = Beide Punkte dieser Zeile sind gleich.
    .do = Zwei verschiedene Punkte angeben.

observation-set_station = Satz { $set } hat in einer früheren Zeile einen anderen Standpunkt.
    .do = Jedem Satz einen Standpunkt geben.

observation-zenith_angle = { NUM($angle_deg, digits: 6) }° ist kein Zenitwinkel (0° bis 180°, 0 bis 200 gon).
    .do = Für Lage II 360° (400 gon) minus Ablesung angeben.

observation-parameter_twice = { $parameter } dieses Bildes hat schon eine Zeile.
    .do = Eine der beiden Zeilen löschen.
