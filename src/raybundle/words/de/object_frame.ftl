object_frame-origin_missing = Der Ursprung des Objektsystems fehlt.
    .do = { $degrees ->
        [yes] origin = [longitude_deg, latitude_deg, height_m] angeben
       *[no] origin = [east, north, height] angeben
     }.

object_frame-crs_missing = Ein projiziertes System braucht sein Koordinatensystem.
    .do = Zum Beispiel crs = "EPSG:32633" ergänzen.

object_frame-not_degrees = Geographische Länge { $longitude_deg }, Breite { $latitude_deg } sind keine gültigen Werte in Grad.
    .do = Zuerst die geographische Länge, dann die Breite angeben.

object_frame-missing = Eine Satellitenszene braucht ein Objektsystem mit bekannter Lage.
    .do = [frame] mit kind = "local" und origin = [longitude_deg, latitude_deg, height_m] ergänzen.

object_frame-not_local = Höhen in Landeskoordinaten brauchen einen Block in einem lokalen System (Ost, Nord, oben).
    .do = Dem Block ein [frame] mit kind = "local" geben.

object_frame-needs_metres = Block { $block } hat einen [frame] mit Koordinatensystem, aber Längen in { $unit }.
    .do = Den Block in Metern angeben: length_unit = "m".

object_frame-far_from_origin = Block { $block }: Koordinaten bei { NUM($x_m, digits: 6) }, { NUM($y_m, digits: 6) } m passen nicht zu [frame] kind = "projected".
    .why = Solche Koordinaten sind die von { $system } selbst, mit dem Ursprung bei { NUM($origin_x_m, digits: 10) }, { NUM($origin_y_m, digits: 10) } m.
    .do = Wenn es Meter nach Osten, Norden und oben ab dem Ursprung sind, kind = "local" mit gleichem crs und Ursprung schreiben.

object_frame-needs_local = Block { $block }: { $tables } benötigt ein lokales System; der Block hat Landeskoordinaten.
    .why = Die Achsen solcher Beobachtungen sind in Landeskoordinaten nicht überall gleich.
    .do = Den Block mit [frame] kind = "local", gleichem crs und Koordinaten ab dem Ursprung angeben.
