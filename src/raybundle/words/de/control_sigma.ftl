control_sigma = Die Passpunkte haben keine Standardabweichungen; { $plan_m } m in der Lage angenommen, wie sie zu den Aufnahmen passen.
    .why = Für Höhen sind es { $height_m } m; üblich sind { $assumed_plan_m } m in der Lage und { $assumed_height_m } m in der Höhe.
    .do = sX, sY, sZ angeben, wenn sie bekannt sind.
