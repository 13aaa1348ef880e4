frame-unknown_rig = Frame { $frame } verweist auf Rig { $rig }, das fehlt.
    .do = Die Nummer korrigieren oder das Rig ergänzen.

frame-unknown_sensor = Frame { $frame } verweist auf Sensor { $sensor }, den Rig { $rig } nicht hat.
    .do = Die Nummer korrigieren oder den Sensor ergänzen.
