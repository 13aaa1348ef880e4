scene_control-height_unit = Die Passpunkthöhen sind wohl in { $unit } statt in Metern angegeben.
    .why = Aus { $shift_px } px Bildverschiebung und { NUM($rms_px, digits: 2) } px Verbesserungen werden { $shift_then_px } px und { NUM($rms_then_px, digits: 2) } px.
    .do = Die Höhen in Metern angeben ({ $unit } mal { NUM($factor, digits: 10) }).

scene_control-image_axes = Die Passpunkte drehen oder strecken das Bild um { PERCENT($share) } % mit dem Bias { $model } (Grenze { PERCENT($limit) } %).
    .why = { $cause ->
        [none] Ein RPC hat keinen solchen Fehler.
       *[other] Ein RPC hat keinen solchen Fehler. Mit der folgenden Korrektur passen die Punkte auf { $rms_px } px.
     }
    .do = { $cause ->
        [exchanged] x_px und y_px tauschen
        [x] x_px vom linken Rand zählen
        [y] y_px vom oberen Rand zählen
        [corner] x_px und y_px von der linken oberen Ecke zählen
       *[none] Prüfen, ob Punkte und Szene zusammengehören, und die Folge von x_px und y_px prüfen
     }.

scene_control-other_images = Die Datei enthält keinen Bildpunkt der Szene { $scene }.
    .do = Die Bildnamen darin korrigieren; sie lauten { LIST($others, most: 5) }.

scene_control-geographic_columns = Die Spalten { $columns } sind WGS 84 mit ellipsoidischen Höhen, kein anderes System.
    .do = { OPTION("crs") } und { OPTION("undulation") } weglassen oder die Spalten in X, Y, Z umbenennen.

scene_control-image_points_twice = Die Datei hat eigene Bildpunkte; { $table } kann nicht hinzukommen.
    .do = { OPTION("image_points") } weglassen oder die Spalten x_px, y_px löschen.

scene_control-no_image_point = Die Passpunkte haben keine Bildpunkte.
    .do = Spalten x_px, y_px ergänzen oder eine Tabelle { LIST($columns, most: 6) } als { OPTION("image_points", "FILE.csv") } angeben.

scene_control-no_point = Die Datei enthält keinen Punkt.
    .do = Prüfen, ob es die richtige Datei ist.

scene_control-point_twice = Der Punkt { $point } kommt zweimal vor.
    .do = Einen löschen oder anders benennen.

scene_control-point_missing = Der Punkt { $point } fehlt in { $table }.
    .do = Den Punkt dort ergänzen oder seinen Namen korrigieren.

scene_control-attribute_not_a_number = Attribut { $name }: { $value } ist keine Zahl.
    .do = Eine Zahl angeben.

scene_control-no_image_attributes = Der Punkt hat keine Attribute x_px und y_px.
    .why = { $n ->
     [0] Er hat keine Attribute.
     *[other] Seine Attribute sind { LIST($names, most: 12) }.
    }
    .do = Die Attribute ergänzen oder eine Tabelle { LIST($columns, most: 6) } als { OPTION("image_points", "FILE.csv") } angeben.

scene_control-not_a_point = Die Geometrie ist { $kind }, nicht Point.
    .do = Die Passpunkte als Punkte speichern.

scene_control-coordinate_count = Koordinaten des Punktes: { $n }; nötig: 2 oder 3.
    .do = Geographische Länge, Breite und Höhe angeben.

scene_control-no_layer = Die Datei hat keine Ebene mit { $points ->
     [yes] Punkten
     *[no] den Spalten { LIST($columns, most: 6) }
    }.
    .do = Prüfen, ob es die richtige Datei ist.

scene_control-no_height = { $n } von { $total } Punkten haben keine Höhe; der erste ist { $point }.
    .why = Ein RPC braucht die Höhe jedes Punktes.
    .do = Eine Spalte Z ergänzen oder Punkte mit drei Koordinaten speichern.

scene_control-other_system = Die Passpunkte liegen in { $own } vor, { OPTION("crs") } ist { $system }.
    .do = { OPTION("crs") } weglassen oder das System der Datei mit seinen Höhen angeben.

scene_control-not_degrees = Punkt { $point } ({ NUM($x, digits: 10) }, { NUM($y, digits: 10) }) ist nicht in Grad, und kein Koordinatensystem ist angegeben.
    .do = { OPTION("crs", "EPSG:CODE") } angeben.

scene_control-not_points = Die Geometrie dieser Zeile ist kein Punkt.
    .do = Die Passpunkte als Punkte speichern.

scene_control-image_assumed = Die Bildpunkte aus { $name } gehören zu { $image }; sie werden für { $scene } verwendet.

scene_control-wgs84_assumed = Koordinatensystem der Passpunkte: nicht angegeben; WGS 84 mit ellipsoidischen Höhen angenommen.
    .do = { OPTION("crs", "EPSG:CODE") } angeben, wenn es ein anderes ist.

scene_control-columns_missing = Die Spalten { LIST($header, most: 12) } ergeben keine Passpunkttabelle.
    .why = Nötig sind { LIST($geographic, most: 9) } oder { LIST($grid, most: 9) }.
    .do = Die fehlenden Spalten ergänzen oder eine Tabelle { LIST($image_points, most: 9) } als { OPTION("image_points", "FILE.csv") } angeben.

scene_control-check_only = Alle Punkte sind Kontrollpunkte.
    .do = Mindestens einen davon zum Passpunkt machen.

scene_control-image_missing = Es gibt { $n } Szenen, aber Punkte nennen nicht das Bild, in dem sie gemessen sind.
    .do = Eine Spalte image ergänzen.
