read_out-time = Eine Auslesezeit von { NUM($time_ms, decimals: 0) } ± { NUM($sigma_ms, decimals: 0) } ms verkleinert Chi-Quadrat um { NUM($by_read_out, decimals: 0) }, Affinität und Scherung um { NUM($by_shape, decimals: 0) }.

read_out-share = Ein Auslesen über { PERCENT($share) } % des Aufnahmeabstands verkleinert Chi-Quadrat um { NUM($by_read_out, decimals: 0) }, Affinität und Scherung um { NUM($by_shape, decimals: 0) }.

read_out-given = Die angegebene Auslesezeit von { $time_ms } ms ist mit { PERCENT($sigma_share) } % beobachtet.

read_out-table = Veröffentlichte Messungen dieser Kamera: { NUM($time_ms, decimals: 0) } ms.

read_out-still = { $n } { $n ->
        [one] Aufnahme
       *[other] Aufnahmen
    } ohne Geschwindigkeit (Kurven, Lücken) gelten als unbewegt.

read_out = Kamera { $camera }: Der Rolling Shutter ist modelliert.
    .why = Die Geschwindigkeit einer Aufnahme folgt aus den Projektionszentren davor und danach.
