object_frame-origin_missing = Der Ursprung des Objektsystems fehlt.
    .do = { $degrees ->
        [yes] origin = [longitude_deg, latitude_deg, height_m] angeben
       *[no] origin = [east, north, height] angeben
     }.

object_frame-crs_missing = Ein projiziertes System braucht sein Koordinatensystem.
    .do = Zum Beispiel crs = "EPSG:32633" ergänzen.

object_frame-not_degrees = Länge { $longitude_deg }, Breite { $latitude_deg } sind keine gültigen Grad.
    .do = Zuerst die Länge, dann die Breite angeben.

object_frame-missing = Eine Satellitenszene braucht ein Objektsystem mit bekannter Lage.
    .do = [frame] mit kind = "local" und origin = [longitude_deg, latitude_deg, height_m] ergänzen.

object_frame-not_local = Höhen über einer Karte brauchen einen Block in einem lokalen System (Ost, Nord, oben).
    .do = Dem Block ein [frame] mit kind = "local" geben.
