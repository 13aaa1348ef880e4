read_out_unused = { OPTION("read_out", $time_ms) } wird für { $cameras } { $cameras ->
        [one] Kamera
       *[other] Kameras
    } nicht verwendet: Geschwindigkeiten fehlen.
    .why = Geschwindigkeiten folgen aus Projektionszentren und Zeiten.
    .do = Aufnahmen mit Aufnahmezeiten angeben, dazu Positionen, Passpunkte oder eine Maßstabsstrecke.

read_out_unused-camera = Kamera { $camera }: { $lacking ->
        [times] ihre Aufnahmen haben keine Zeiten
        [scale] der Maßstab ist nicht bestimmt
       *[velocities] Aufnahmen mit Geschwindigkeit: { $n }; nötig: { $least }
    }.
