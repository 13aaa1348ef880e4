scene_control-height_unit = Die Passpunkthöhen sind wohl in { $unit } statt in Metern angegeben.
    .why = Aus { $shift_px } px Bildverschiebung und { NUM($rms_px, digits: 2) } px Residuen werden { $shift_then_px } px und { NUM($rms_then_px, digits: 2) } px.
    .do = Die Höhen in Metern angeben ({ $unit } mal { NUM($factor, digits: 10) }).

scene_control-image_axes = Die Passpunkte drehen oder strecken das Bild um { PERCENT($share) } % mit dem Bias { $model } (Grenze { PERCENT($limit) } %).
    .why = { $cause ->
        [none] Ein RPC hat keinen solchen Fehler.
       *[other] Ein RPC hat keinen solchen Fehler. Mit der folgenden Berichtigung passen die Punkte auf { $rms_px } px.
     }
    .do = { $cause ->
        [exchanged] x_px und y_px tauschen
        [x] x_px vom linken Rand zählen
        [y] y_px vom oberen Rand zählen
        [corner] x_px und y_px von der linken oberen Ecke zählen
       *[none] Prüfen, ob Punkte und Szene zusammengehören, und die Folge von x_px und y_px prüfen
     }.
