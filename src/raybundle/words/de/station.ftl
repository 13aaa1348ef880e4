station-velocity_unknown = Der Zeitversatz dt braucht die Geschwindigkeit jedes Bildes; sie fehlt für { $images }.
    .do = Geschwindigkeiten oder Zeiten benachbarter Bilder der Fluglinie angeben, oder dt auf 0 festhalten.

station-shared_with_parameters = Das Bild { $image } teilt seinen Standpunkt und hat eigene Parameter (Kamera { $camera }).
    .do = Den gemeinsamen Standpunkt oder per_image der Kamera entfernen.

station-orientations_differ = Die Bilder { $images } teilen einen Standpunkt, haben aber verschiedene äußere Orientierungen.
    .do = Jedem Bild die Orientierung des Kameraverbunds geben und die Versätze als Parameter der montierten Kameras angeben.

station-partly_held = Die Bilder { $images } teilen einen Standpunkt, und nur einige sind festgehalten.
    .do = Alle oder keines festhalten.
