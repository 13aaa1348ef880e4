frame-unknown_rig = Frame { $frame } : le rig { $rig } manque.

frame-unknown_sensor = Frame { $frame } : le capteur { $sensor } manque dans le rig { $rig }.
