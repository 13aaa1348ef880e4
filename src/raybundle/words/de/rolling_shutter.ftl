rolling_shutter = Kamera { $camera }: Affinität und Scherung sind die Wirkung eines Rolling Shutters.
    .why = Er ist nicht modelliert; die Standardabweichungen sind zu klein.
    .do = Aufnahmen mit Aufnahmezeiten und einen Maßstab (Positionen, Passpunkte oder eine Maßstabsstrecke) angeben, langsamer fliegen oder für jede Aufnahme anhalten.

rolling_shutter-possible = Kamera { $camera }: Affinität und Scherung sind vielleicht die Wirkung eines Rolling Shutters.
    .why = Die Geschwindigkeiten in den Achsen der Kamera sind zu ähnlich, um beides zu trennen; die Standardabweichungen sind zu klein.
    .do = Die Auslesezeit angeben ({ OPTION("read_out") }), langsamer fliegen oder für jede Aufnahme anhalten.
