attitudes_mount = Die Kamera ist um { NUM($angle_deg, decimals: 0) }°{ $quarter ->
     [yes] { "" } um ihre Blickrichtung
     *[no] { "" }
    } gegen die Lagewinkel { $source ->
     [gimbal] des Gimbals
     *[other] aus { $source }
    } gedreht.
    .why = Das gilt als ihr Einbau{ $alike ->
     [yes] ; alle Flugrichtungen sind gleich, so dass ein falscher Gierwinkel ebenso aussähe
     *[no] { "" }
    }.
    .do = { $alike ->
     [yes] Die Gierwinkel prüfen.
     *[no] { "" }
    }
