control_sigma = Die Passpunkte haben keine Standardabweichungen; { $plan_m } m in der Lage angenommen, wie sie zu den Aufnahmen passen.
    .why = Höhen: { $height_m } m (statt { $assumed_plan_m } m und { $assumed_height_m } m).
    .do = sX, sY, sZ angeben, wenn sie bekannt sind.
