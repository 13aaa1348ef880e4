measurement-unknown_points = { $name } hat keinen Punkt { $points }.
    .do = Die Punktnamen korrigieren.

measurement-shapes = { $name }: { $n } Namen, Koordinaten der Dimension ({ $xyz }), Kovarianz der Dimension ({ $covariance }).
    .do = Koordinaten (n, 3) und eine Kovarianzmatrix (3n, 3n) angeben.

measurement-point_twice = { $name } enthält Punkt { $point } zweimal.
    .do = Einen davon löschen oder umbenennen.

measurement-points = Gemessen: { $points } { $points ->
        [one] Punkt
        *[other] Punkte
    } in { $images } von { $of } Aufnahmen.

measurement-precision = Standardabweichung einer Koordinate: { NUM($rms, digits: 2) } { $free_scale ->
        [yes] Tausendstel, Maßstab willkürlich
        *[no] mm
    } (RMS), größte { NUM($largest, digits: 2) } (Punkt { $point }).

measurement-fit = Abweichungen von den Sollwerten: { NUM($rms_mm, digits: 2) } mm (RMS), größte { NUM($largest_mm, digits: 2) } mm ({ $point }); { $significant } von { $of } signifikant.

measurement-tolerances = Toleranzen (ISO 14253-1): { $within } eingehalten, { $beyond } überschritten{ $beyond ->
        [0] {""}
        *[other] {" "}({ $names })
    }, { $undecided } unentschieden.

measurement-scale = Maßstabsfaktor der Einpassung: { NUM($scale, decimals: 7) } ± { NUM($sigma, digits: 1) }.

measurement-lengths = { $n } bekannte { $n ->
        [one] Länge
        *[other] Längen
    }: Abweichung { NUM($rms_mm, digits: 2) } mm (RMS), größte { NUM($largest_mm, digits: 2) } mm ({ $start } - { $end }){ $judged ->
        [met] ; Grenzen eingehalten
        *[none] {""}
        [exceeded] ; { $over } über der Grenze
    }.

measurement-length_test = { PERCENT($within) } % der Abweichungen liegen innerhalb von zwei Standardabweichungen; Test aller: F = { $F } ({ P($p) }).

measurement-lengths_served = { $independent ->
        [yes] { $n } der Längen dienten als Maßstabsstrecken.
        *[no] Alle Längen dienten als Maßstabsstrecken: sie sind keine Prüfung.
    }
