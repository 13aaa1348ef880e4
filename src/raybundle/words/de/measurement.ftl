measurement-unknown_points = { $name } hat keinen Punkt { $points }.
    .do = Die Punktnamen berichtigen.

measurement-shapes = { $name }: { $n } Namen, Koordinaten der Form ({ $xyz }), Kovarianz der Form ({ $covariance }).
    .do = Koordinaten (n, 3) und eine Kovarianzmatrix (3n, 3n) angeben.

measurement-point_twice = { $name } enthält Punkt { $point } zweimal.
    .do = Einen davon löschen oder umbenennen.
