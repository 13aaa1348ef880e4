patb-photograph_line = Eine Aufnahme beginnt mit ihrer Nummer und der Kamerakonstante in µm.
    .do = Diese Zeile vervollständigen.

patb-image_point_line = Ein Bildpunkt braucht drei Wörter: Punkt, x und y.
    .do = Die Zeile vervollständigen oder { $end } nach der vorigen Aufnahme ergänzen.

patb-photograph_not_closed = Die Aufnahme { $photograph } ist nicht mit { $end } abgeschlossen.
    .do = Die vollständige Datei beschaffen.

patb-camera_constant = { NUM($c_um, digits: 6) } ist keine Kamerakonstante in µm.
    .do = Einen positiven Wert in µm angeben.

patb-rotation_missing = Aufnahme { $photograph }: Die Drehung fehlt.
    .do = Die vollständige Datei beschaffen.
