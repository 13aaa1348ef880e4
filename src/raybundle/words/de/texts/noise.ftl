noise-singular_points = manche Bildpunkte bestimmen ihre Objektpunkte nicht

noise-few_directions = die Verbesserungen bestimmen nur { $n } Richtungen glatter Fehler ({ $least } nötig)

noise-no_statistics = die Statistik ist abgeschaltet

noise-no_redundancy = es gibt keine Redundanz

noise-rig = Bilder teilen die äußere Orientierung eines Kameraverbunds

noise-no_format = das Sensormodell { $models } hat kein ebenes Format

noise-too_few_photographs = { $n } Fotos sind zu wenige für eigene glatte Fehler (mindestens { $least } sind nötig)
