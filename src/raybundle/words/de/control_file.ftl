control_file-no_sigma = { $name } enthält keine Standardabweichungen; angenommen werden { NUM($off_mm, digits: 2) } mm, wie die Punkte zum Netz passen.
    .do = sX, sY, sZ angeben, wenn sie bekannt sind.

control_file-not_measured = { $n } { $n ->
        [one] Passpunkt wurde
       *[other] Passpunkte wurden
     } nicht gemessen: { LIST($ids, most: 10) }.

control_file-tolerance = Die Spalte tolerance in { $name } wird nicht verwendet: Sie gehört zu Sollkoordinaten.
