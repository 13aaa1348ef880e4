positions_assumed = { $n } { $n ->
     [one] Position hat
     *[other] Positionen haben
    } keine Standardabweichung; { $plan_m } m in der Lage und { $height_m } m in der Höhe angenommen.
    .do = Die Standardabweichungen in der Positionsdatei angeben, wenn sie bekannt sind.
