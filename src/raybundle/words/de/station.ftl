station-velocity_unknown = Der Zeitversatz dt braucht die Geschwindigkeit jedes Bildes; sie fehlt für { $images }.
    .do = Geschwindigkeiten oder Zeiten benachbarter Bilder der Fluglinie angeben, oder dt auf 0 festhalten.
